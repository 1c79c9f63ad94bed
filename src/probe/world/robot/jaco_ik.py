"""Closed-form inverse kinematics of the Jaco j2s6s300. Knows neither obstacles nor the hand.

Axes 4, 5 and 6 meet in one point, which splits the problem: the first three joints take that point
to its place, and the last three turn the hand.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from probe.types import Array, Pose
from probe.world.robot.ik import wrap
from probe.world.robot.jaco import (
    D1,
    D2,
    D5,
    E2,
    FOREARM,
    LIMITS,
    OFFSET,
    forward_matrix,
    link_transform,
)

EDGE = 1e-9  # rounding allowed beyond the edge of the workspace: of cosines, metres and limits
SINGULAR = 1e-9  # |sin| of joint 5 under which axes 4 and 6 count as parallel
TOLERANCE = 1e-6  # largest difference of any matrix element from the pose asked for


def inverse(base_from_tool0: Pose) -> list[Array]:
    """All joint configurations within the limits that reach a pose of tool0.

    Args:
        base_from_tool0: In the arm's base frame, metres.

    Returns:
        Up to eight arrays of shape (6,) in radians, in lexical order, joints that turn without end
        in (-pi, pi]; empty where the pose is out of reach. Where the wrist is straight, joints 4
        and 6 turn about one axis and solutions are without number: only those with joint 6 at zero.
    """
    target = base_from_tool0.matrix
    found: dict[tuple[float, ...], Array] = {}
    for shoulder in _shoulders(target):
        for wrist in _wrists(target, shoulder):
            joints = _within_limits(np.array([*shoulder, *wrist]))
            if joints is None or np.abs(forward_matrix(joints) - target).max() > TOLERANCE:
                continue
            found.setdefault(tuple(np.round(joints, 7).tolist()), joints)
    return [found[key] for key in sorted(found)]


def _within_limits(joints: Array) -> Array | None:
    """The same angles where the limits have them, or None if they don't."""
    joints = wrap(joints)
    for index, limits in enumerate(LIMITS):
        if limits is None:
            continue
        joints[index] %= 2 * math.pi
        if not limits[0] - EDGE <= joints[index] <= limits[1] + EDGE:
            return None
    return joints


def _shoulders(target: Array) -> Iterator[tuple[float, float, float]]:
    """Angles of joints 1, 2 and 3 that put the wrist's centre where it has to be."""
    x, y, z = target[:3, 3] - D5 * target[:3, 2]
    distance = math.hypot(x, y)
    if distance < E2 - EDGE:
        return
    # Seen from the base's underside, as joint 1 turns.
    bearing, beside = math.atan2(-y, x), math.asin(min(E2 / distance, 1.0))
    for pan in (bearing - beside, bearing - math.pi + beside):
        ahead = math.cos(pan) * x - math.sin(pan) * y
        for first, bend in _two_links(ahead, z - D1):
            yield pan, first - OFFSET[1], -bend - math.pi / 2 - OFFSET[2]


def _two_links(ahead: float, above: float) -> Iterator[tuple[float, float]]:
    """The upper arm's angle from level, and the forearm's from the upper arm."""
    square = ahead * ahead + above * above
    cosine = (square - D2**2 - FOREARM**2) / (2 * D2 * FOREARM)
    if abs(cosine) > 1 + EDGE:
        return
    angle = math.acos(max(-1.0, min(1.0, cosine)))
    for bend in (angle, -angle) if angle > 0 else (angle,):
        inner = math.atan2(FOREARM * math.sin(bend), D2 + FOREARM * math.cos(bend))
        yield math.atan2(above, ahead) - inner, bend


def _wrists(
    target: Array, shoulder: tuple[float, float, float]
) -> Iterator[tuple[float, float, float]]:
    """Angles of joints 4, 5 and 6.

    Seen from axis 4, the hand's turn is Rz(q4) K Rz(q6), where K has the rows (cos q5, 0, sin q5),
    (0, -1, 0) and (sin q5, 0, -cos q5).
    """
    before = np.eye(4)
    for joint, angle in enumerate(shoulder):
        before = before @ link_transform(joint, angle)
    # The maker's last frame looks back from the hand; a quarter turn about x comes before axis 4.
    turn = before[:3, :3].T @ target[:3, :3] @ np.diag([1.0, -1.0, -1.0])
    turn = np.array([turn[0], turn[2], -turn[1]])
    sine = math.hypot(turn[0, 2], turn[1, 2])
    if sine < SINGULAR:
        yield math.atan2(-turn[1, 0], -turn[0, 0]), math.pi, 0.0
        return
    for sign in (1.0, -1.0):
        yield (
            math.atan2(sign * turn[1, 2], sign * turn[0, 2]),
            math.atan2(sign * sine, -turn[2, 2]),
            math.atan2(-sign * turn[2, 1], sign * turn[2, 0]),
        )
