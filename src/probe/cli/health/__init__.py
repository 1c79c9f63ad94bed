"""What `probe doctor` looks at: one file for each kind of thing that may be missing."""
