"""Checks of a robot that need a known thing: where its cameras stand, and what it can reach."""
