"""Imported for what it registers; nothing of it is used by name."""
