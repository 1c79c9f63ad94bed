"""Further examples from the same episodes: mirrored left to right, or asked in other words."""
