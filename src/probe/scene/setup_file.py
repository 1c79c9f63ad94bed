"""A Setup on disk."""

MOST_PX = 4096
