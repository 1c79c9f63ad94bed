"""The pools of the library: procedural objects, scans, a user's own."""
