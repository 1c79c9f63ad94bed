"""Words on objects: asked of a model, corrected by hand, each with who said it."""
