"""Further examples from the same episodes: mirrored, or told in other words."""
