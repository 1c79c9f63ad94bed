"""A robot that isn't there: a simulated table behind the same bridge as a real one."""
