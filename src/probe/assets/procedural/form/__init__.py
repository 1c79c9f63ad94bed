"""Surfaces and convex pieces of simple solids. No colour, no names."""
