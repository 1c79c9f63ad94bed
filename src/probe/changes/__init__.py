"""What became of each thing between two looks at the table and into the basket, by camera alone."""
