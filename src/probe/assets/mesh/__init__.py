"""Triangle meshes, and what is measured on them. Knows no file format."""
