"""Chosen episodes as a data set: pictures drawn from records, forms for three trainers."""
