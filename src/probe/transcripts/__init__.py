"""An episode as the messages that a model sees: one form for asking and for training."""
