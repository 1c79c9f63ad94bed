"""What a person at a robot sees and presses: motions that wait for a yes, and a stop."""
