"""A model from a data set: loaded or made from nothing, trained with TRL, its diary and card."""
