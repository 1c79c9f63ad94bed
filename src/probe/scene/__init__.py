"""The table as data: what stands on it, and where. No physics, no pixels."""
