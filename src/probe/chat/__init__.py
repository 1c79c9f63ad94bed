"""An episode as the messages that a model sees: one form for asking models and for training them."""
