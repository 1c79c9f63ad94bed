"""One agent at one table: run it, keep a record of all that happened, run it again."""
