"""Whether records agree with themselves, their suite and their folder. Moves and draws nothing."""
