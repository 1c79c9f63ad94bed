"""Episodes as films: what moved, seen by a camera that no agent has. Tools know nothing of it."""
