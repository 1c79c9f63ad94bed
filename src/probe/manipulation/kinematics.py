"""Joint paths for poses of the hand. Knows no obstacles."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from probe.station.station import Arm
from probe.types import Array, Pose, Vector3

_JUMP = 0.5
_STEP = 0.02
_HALF_TURN = Pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def reaching(arm: Arm, world_from_hand: Pose, near: Array) -> list[Array]:
    """Joint angles that put the hand somewhere, those first that move the joints least.

    Whole turns are added to the joints that may take them.
    """
    turn = 2 * math.pi
    found: list[Array] = []
    for joints in arm.inverse(world_from_hand):
        turned = joints.copy()
        for index in arm.endless:
            turned[index] += turn * round((near[index] - joints[index]) / turn)
        found.append(turned)
    return sorted(found, key=lambda joints: float(np.abs(joints - near).max()))


def either_way(world_from_hand: Pose) -> tuple[Pose, Pose]:
    """A pose and the same with the two fingers swapped."""
    return world_from_hand, world_from_hand @ _HALF_TURN


def straight(arm: Arm, start: Array, poses: Iterable[Pose]) -> Array | None:
    """Joint angles along neighbouring poses, shape (m, n), all of one branch; None without one."""
    path: list[Array] = []
    last = start
    for pose in poses:
        solutions = reaching(arm, pose, last)
        if not solutions or np.abs(solutions[0] - last).max() > _JUMP:
            return None
        last = solutions[0]
        path.append(last)
    return np.array(path)


def line(start: Pose, offset: Array | Vector3) -> list[Pose]:
    """Poses from a pose (left out) straight to the same pose moved by an offset, shape (3,)."""
    shift = np.asarray(offset, dtype=float)
    count = max(1, math.ceil(float(np.linalg.norm(shift)) / _STEP))
    return [moved(start, shift * k / count) for k in range(1, count + 1)]


def moved(pose: Pose, offset: Array | Vector3) -> Pose:
    """The same orientation, the position moved by an offset in the world."""
    return Pose.of(np.asarray(pose.position) + np.asarray(offset), np.array(pose.wxyz))


def turned(pose: Pose, angle: float) -> Pose:
    """The pose turned about the vertical through the world's origin."""
    return Pose((0.0, 0.0, 0.0), (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))) @ pose


def between(path: Sequence[Array] | Array, step: float = 0.12) -> Array:
    """Joint angles along a path of at least two, no joint further than a step apart."""
    points = [np.asarray(path[0])[None]]
    for start, end in zip(path[:-1], path[1:], strict=True):
        count = max(1, math.ceil(float(np.abs(end - start).max()) / step))
        points.append(start + (end - start) * np.arange(1, count + 1)[:, None] / count)
    return np.concatenate(points)
