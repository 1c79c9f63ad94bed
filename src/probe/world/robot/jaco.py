"""The Jaco j2s6s300's kinematics and limits as numbers and pure functions. Knows no engine.

Source: the lengths in Kinova's user guide, by its table of Denavit-Hartenberg parameters for the
arm with a spherical wrist; limits, torques and speeds: the maker's ROS description (j2s6s300).
Angles are what the maker's driver reports, its zero included. ``base`` stands on the table with z
up; ``tool0`` lies where the hand begins, z out of it, its one finger (the thumb) on the +y side.
The maker's end effector lies 0.16 m ahead of tool0, between the open fingers.

Axes 4, 5 and 6 meet in one point.
"""

from __future__ import annotations

import math

import numpy as np

from probe.types import Array, Pose

JOINTS = ("joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6")
"""Joint names from the base outwards."""

D1, D2, D3, D4, D5 = 0.2755, 0.4100, 0.2073, 0.1038, 0.1038
"""Base to shoulder, shoulder to elbow, forearm, first wrist, second wrist, metres."""

E2 = 0.0098
"""How far the forearm lies beside the shoulder, metres."""

HAND_CENTRE = 0.16
"""From tool0 to the maker's end effector along z, metres (D6)."""

FOREARM = D3 + D4
"""From the elbow to where the axes of the wrist meet, metres."""

SHIFT = (0.0, 0.0, D2, 0.0, 0.0, 0.0)
TWIST = (math.pi, -math.pi / 2, math.pi, math.pi / 2, math.pi / 2, math.pi / 2)
ALONG = (-D1, 0.0, -E2, -FOREARM, 0.0, -D5)
OFFSET = (0.0, -math.pi / 2, math.pi / 2, 0.0, 0.0, 0.0)
"""Before each joint a shift along x and a twist about it; then a shift along z and a turn about it
by the joint's angle plus its offset. After the last one half a turn about x."""

LIMITS: tuple[tuple[float, float] | None, ...] = (
    None,
    (math.radians(47.0), math.radians(313.0)),
    (math.radians(19.0), math.radians(341.0)),
    None,
    (math.radians(30.0), math.radians(330.0)),
    None,
)
"""Smallest and largest joint angles, radians; joints 1, 4 and 6 turn without end."""

ENDLESS = tuple(index for index, limits in enumerate(LIMITS) if limits is None)

JOINT_SPEED = math.radians(36.0)
"""Largest speed of joints 1 to 3, radians per second; the others turn at 48 degrees a second."""

TORQUE_LIMIT = (40.0, 80.0, 40.0, 20.0, 20.0, 20.0)
"""Largest joint torque, newton metres."""

_FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


def link_transform(joint: int, angle: float) -> Array:
    """Transform from link `joint` to link `joint` + 1 (0 = base), shape (4, 4)."""
    c, s = math.cos(angle + OFFSET[joint]), math.sin(angle + OFFSET[joint])
    ct, st = math.cos(TWIST[joint]), math.sin(TWIST[joint])
    a, d = SHIFT[joint], ALONG[joint]
    return np.array(
        [
            [c, -s, 0.0, a],
            [s * ct, c * ct, -st, -st * d],
            [s * st, c * st, ct, ct * d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def forward_matrix(joints: Array) -> Array:
    """base_from_tool0 as a homogeneous matrix, shape (4, 4), of joint angles, shape (6,)."""
    matrix = np.eye(4)
    for joint, angle in enumerate(joints):
        matrix = matrix @ link_transform(joint, float(angle))
    return matrix @ _FLIP


def forward(joints: Array) -> Pose:
    """base_from_tool0 of joint angles in radians, shape (6,)."""
    return Pose.from_matrix(forward_matrix(joints))
