"""The robot: a UR5 with a Robotiq 2F-140, its kinematics, and its model. Knows no table or task."""
