"""Pages and pictures for people. Reads values and files; runs nothing."""
