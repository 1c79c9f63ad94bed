"""What a folder of records claims: done again and compared, hashed, signed. Grades nothing."""
