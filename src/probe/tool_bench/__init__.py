"""The tools alone, on true targets: how often they work, and why they don't."""
