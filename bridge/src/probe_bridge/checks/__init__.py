"""Checks of a robot over its bridge that need no numpy; they run from this wheel alone."""
