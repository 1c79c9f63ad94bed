"""What stands in a film beside the objects: the robot, its basket, a table with legs, a room."""
