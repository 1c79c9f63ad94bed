"""Ways in for others: programs that bring their own agent to a table of ours."""
