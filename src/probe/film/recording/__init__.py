"""Episodes as recordings for Rerun's viewer: what the tools saw, thought of and did, in 3D."""
