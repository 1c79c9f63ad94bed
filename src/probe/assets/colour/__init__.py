"""Colours by their everyday names."""
