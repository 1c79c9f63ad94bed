"""glTF and GLB files, checked before they are read."""
