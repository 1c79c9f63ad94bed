"""The UR5's kinematics and limits as numbers and pure functions. Knows no engine and no gripper.

Source: Universal Robots, "DH parameters for calculations of kinematics and dynamics", table
"UR5" (CB3 series), and the CB3 manual for the limits. Frames follow the maker: ``base`` is the
frame shown on the teach pendant, ``tool0`` the flange with z pointing out of it.
"""

from __future__ import annotations

import math

import numpy as np

from probe.types import Array, Pose

JOINTS = ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3")
"""Joint names from the base outwards."""

A = (0.0, -0.425, -0.39225, 0.0, 0.0, 0.0)
D = (0.089159, 0.0, 0.0, 0.10915, 0.09465, 0.0823)
ALPHA = (math.pi / 2, 0.0, 0.0, math.pi / 2, -math.pi / 2, 0.0)
"""Denavit-Hartenberg parameters (classic convention): metres, metres, radians."""

JOINT_LIMIT = np.array([2.0, 2.0, 1.0, 2.0, 2.0, 2.0]) * math.pi
"""Largest absolute joint angle, radians, shape (6,)."""

JOINT_SPEED = math.pi
"""Largest joint speed, radians per second."""

TORQUE_LIMIT = (150.0, 150.0, 150.0, 28.0, 28.0, 28.0)
"""Largest joint torque, newton metres."""


def link_transform(joint: int, angle: float) -> Array:
    """DH transform from frame `joint` to frame `joint` + 1 (0 = base), shape (4, 4)."""
    c, s = math.cos(angle), math.sin(angle)
    ca, sa = math.cos(ALPHA[joint]), math.sin(ALPHA[joint])
    a, d = A[joint], D[joint]
    return np.array(
        [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0.0, sa, ca, d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def forward_matrix(joints: Array) -> Array:
    """base_from_tool0 as a homogeneous matrix, shape (4, 4), of joint angles, shape (6,)."""
    matrix = np.eye(4)
    for joint, angle in enumerate(joints):
        matrix = matrix @ link_transform(joint, float(angle))
    return matrix


def forward(joints: Array) -> Pose:
    """base_from_tool0 of joint angles in radians, shape (6,)."""
    return Pose.from_matrix(forward_matrix(joints))
