"""Closed-form inverse kinematics of the UR5. Knows neither obstacles nor the gripper.

Axes 2, 3 and 4 are parallel, which splits the problem: the pan angle from where the wrist is, the
last two angles from how those axes are seen from the tool, the rest is a planar arm of two links.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from probe.types import Array, Pose
from probe.world.robot.ur5 import JOINT_LIMIT, A, D, forward_matrix, link_transform

EDGE = 1e-9  # rounding allowed beyond the edge of the workspace, as a cosine
SINGULAR = 1e-9  # |sin| of wrist 2 under which axes 4 and 6 count as parallel
TOLERANCE = 1e-6  # largest difference of any matrix element from the pose asked for


def inverse(base_from_tool0: Pose) -> list[Array]:
    """All joint configurations that reach a flange pose.

    Args:
        base_from_tool0: Pose of the flange in the arm's base frame, metres.

    Returns:
        Up to eight arrays of shape (6,) in radians, each angle in (-pi, pi], in lexical order;
        empty where the pose is out of reach. Where wrist 2 is straight, wrist 1 and wrist 3 turn
        about parallel axes and solutions are without number: only those with wrist 3 at zero.
    """
    target = base_from_tool0.matrix
    found: dict[tuple[float, ...], Array] = {}
    for pan in _pans(target):
        for wrist_2, wrist_3 in _wrists(target, pan):
            for lift, elbow, wrist_1 in _planar(target, pan, wrist_2, wrist_3):
                joints = wrap(np.array([pan, lift, elbow, wrist_1, wrist_2, wrist_3]))
                if np.abs(forward_matrix(joints) - target).max() < TOLERANCE:
                    found.setdefault(tuple(np.round(joints, 7).tolist()), joints)
    return [found[key] for key in sorted(found)]


def wrap(joints: Array) -> Array:
    """The same angles in (-pi, pi]."""
    return -((math.pi - joints) % (2 * math.pi) - math.pi)


def nearest(solutions: Sequence[Array], reference: Array) -> Array:
    """The solution that moves the joints least from a reference, with whole turns added.

    Args:
        solutions: At least one configuration, each of shape (6,).
        reference: Where the arm is, shape (6,).

    Returns:
        Joint angles within the joint limits with the smallest Euclidean distance, shape (6,).
    """
    unwound = [_unwind(solution, reference) for solution in solutions]
    return min(unwound, key=lambda joints: float(np.linalg.norm(joints - reference)))


def _unwind(joints: Array, reference: Array) -> Array:
    turns = joints[:, None] + 2 * math.pi * np.arange(-2, 3)
    distance = np.abs(turns - reference[:, None])
    distance[np.abs(turns) > JOINT_LIMIT[:, None] + EDGE] = np.inf
    return turns[np.arange(len(joints)), distance.argmin(axis=1)]


def _arccos(cosine: float) -> tuple[float, ...]:
    """Both angles of a cosine, one if they fall together, none if there is none."""
    if abs(cosine) > 1 + EDGE:
        return ()
    angle = math.acos(max(-1.0, min(1.0, cosine)))
    return (angle, -angle) if angle > 0 else (angle,)


def _pans(target: Array) -> Iterator[float]:
    """Angles of joint 1: the point where axes 5 and 6 meet lies D[3] beside the arm's plane."""
    x, y = target[:2, 3] - D[5] * target[:2, 2]
    distance = math.hypot(x, y)
    if distance < SINGULAR:
        return
    for offset in _arccos(D[3] / distance):
        yield math.atan2(y, x) + math.pi / 2 + offset


def _wrists(target: Array, pan: float) -> Iterator[tuple[float, float]]:
    """Angles of joints 5 and 6.

    The common direction n of axes 2, 3 and 4, seen from the tool, is
    (sin q5 cos q6, -sin q5 sin q6, cos q5).
    """
    normal = np.array([math.sin(pan), -math.cos(pan), 0.0])
    x, y, z = (float(v) for v in target[:3, :3].T @ normal)
    sine = math.hypot(x, y)
    for wrist_2 in (math.atan2(sine, z), math.atan2(-sine, z)):
        sign = math.copysign(1.0, wrist_2)
        yield wrist_2, 0.0 if sine < SINGULAR else math.atan2(-y * sign, x * sign)


def _planar(
    target: Array, pan: float, wrist_2: float, wrist_3: float
) -> Iterator[tuple[float, float, float]]:
    """Angles of joints 2, 3 and 4: two links in a plane, then the direction of the third."""
    outer = link_transform(4, wrist_2) @ link_transform(5, wrist_3)
    middle = np.linalg.inv(link_transform(0, pan)) @ target @ np.linalg.inv(outer)
    x, y = (float(v) for v in middle[:2, 3])
    direction = math.atan2(middle[1, 0], middle[0, 0])
    cosine = (x * x + y * y - A[1] ** 2 - A[2] ** 2) / (2 * A[1] * A[2])
    for elbow in _arccos(cosine):
        inner = math.atan2(A[2] * math.sin(elbow), A[1] + A[2] * math.cos(elbow))
        lift = math.atan2(y, x) - inner
        yield lift, elbow, direction - lift - elbow
