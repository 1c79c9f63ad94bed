"""The robots: arms with two pads, their kinematics, and their models. Knows no table or task."""
