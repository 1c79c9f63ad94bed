"""Many episodes: which, in how many processes, under which conditions. Grades nothing."""
