"""Convex pieces for an object's collisions. Knows no physics engine."""
