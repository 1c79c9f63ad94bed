"""Pictures that are laid on surfaces: materials and prints. Knows no objects."""
