"""A frame to named things. Knows no arm, no tools, no questions."""
