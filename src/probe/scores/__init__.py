"""Graded episodes to numbers that can be cited. Pure functions: no pictures, no physics."""
