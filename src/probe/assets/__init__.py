"""The object library: what exists, what it looks like, what it weighs. No scenes."""
