"""Behind: what stands out of sight, behind a tall thing, as the front camera sees the table."""
