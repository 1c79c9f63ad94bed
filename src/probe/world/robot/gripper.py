"""The Robotiq 2F-140's kinematics and shape as numbers and pure functions. Knows no engine.

Each finger is a parallelogram: an outer and an inner crank of equal length turn in step, and the
inner finger between them keeps its direction. Lengths: the 2F-140 of ROS-Industrial's robotiq
description, whose pads open to 128.5 mm (the maker states 140 mm); force and speed: the maker's
manual. Grippers of other sizes have longer or shorter cranks.

The gripper's frame is tool0 of the arm: z points out of the hand towards the object, the fingers
close along y. Joint 0 is open, `JOINT_LIMIT` closed.
"""

from __future__ import annotations

import math

from probe.scene.setup import GripperSize
from probe.types import Vector3

ROBOTIQ_2F140 = GripperSize()

JOINT_LIMIT = 0.7
"""Joint angle of the closed gripper, radians."""

TILT = 0.7028
"""Angle of an open crank from the approach axis, radians."""

PIVOT = (0.030601, 0.054905)
"""Axis of an outer crank: distance from the middle and height, metres."""

INNER_PIVOT = (0.0127, 0.06142)
"""Axis of an inner crank."""

PAD_CENTRE = (0.02722, 0.045755)
"""Middle of a pad from the outer end of its crank: inwards and upwards, metres."""

PAD_THICKNESS = 0.0075
"""Of a pad, metres."""

FORCE_RANGE = (10.0, 125.0)
"""Grip force that the maker states, newtons on each pad."""

FINGER_SPEED = 0.125
"""Speed of a pad at most, metres per second (the maker states 250 mm/s for both)."""


def crank(size: GripperSize) -> float:
    """Length of a crank in metres, by how far the pads open: 0.1 for the 2F-140."""
    half = size.max_opening / 2 - PIVOT[0] + PAD_CENTRE[0] + PAD_THICKNESS / 2
    # To the picometre, so that the 2F-140's is what its maker states.
    return round(half / math.sin(TILT), 12)


def pad_half(size: GripperSize) -> Vector3:
    """Half of a pad's width, thickness and length, metres."""
    return size.pad_width / 2, PAD_THICKNESS / 2, size.pad_length / 2


def opening(joint: float, size: GripperSize = ROBOTIQ_2F140) -> float:
    """Distance between the pads' faces in metres: 0.1285 at joint 0, 0 at 0.7 (to 0.2 mm)."""
    half = PIVOT[0] + crank(size) * math.sin(TILT - joint) - PAD_CENTRE[0] - PAD_THICKNESS / 2
    return max(2 * half, 0.0)


def joint_for(opening: float, size: GripperSize = ROBOTIQ_2F140) -> float:
    """Joint angle at which the pads are `opening` metres apart.

    Raises:
        ValueError: The opening lies outside 0 ... max_opening.
    """
    widest = size.max_opening
    if not 0.0 <= opening <= widest + 1e-9:
        raise ValueError(f"the gripper opens from 0 to {widest:.4f} m, not to {opening:.4f} m")
    sine = (opening / 2 - PIVOT[0] + PAD_CENTRE[0] + PAD_THICKNESS / 2) / crank(size)
    return max(TILT - math.asin(sine), 0.0)


def pad_reach(joint: float, size: GripperSize = ROBOTIQ_2F140) -> float:
    """Height of the pads' middle above tool0 in metres: 0.177 open, 0.2007 closed."""
    return PIVOT[1] + crank(size) * math.cos(TILT - joint) + PAD_CENTRE[1]


def tendon_force(pad_force: float, size: GripperSize = ROBOTIQ_2F140) -> float:
    """Force in the drive that presses each pad with `pad_force` newtons when nearly closed.

    By virtual work: the pad moves crank * cos(tilt) a radian, and the drive is shared by two
    fingers. Wide open the same drive presses up to 1.31 times as hard.
    """
    return 2 * crank(size) * pad_force
