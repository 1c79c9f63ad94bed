"""Questions about a table, their options, what is true and what counts as right. No tools."""
