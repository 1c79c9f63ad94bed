"""Joint paths that raise what the hand holds, level where it can be. Moves nothing.

Fingers that pinch an edge steeply would let the thing swing down until it lies along their pads:
its far side would sweep over what lies beneath. So the hand turns as it rises.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.kinematics import line, moved, reaching, straight
from probe.manipulation.obstacles import Obstacles
from probe.scene.setup import Basket
from probe.types import Array, Pose

_LEAST_LIFT, _MOST_LIFT = 0.08, 0.34
_HIGHER = (0.0, 0.07, 0.14)
_LESS = 0.04
_ABOVE = 0.05
_TURN_STEP = np.radians(7.0)
_TURNS_EACH = 2
_JUMP = 0.5


def lifts(
    obstacles: Obstacles, joints: Array, grasp: Grasp, held: Array, points: Array, basket: Basket
) -> Iterator[tuple[Array, float]]:
    """Ways up until what is held is above all nearby, or as far as the arm gets; and higher.

    Args:
        obstacles: All but what is held.
        joints: The arm's, closed on it.
        grasp: How it is held.
        held: Points of it, world, metres, shape (n, 3).
        points: On the hand, in its frame, shape (k, 3).
        basket: Above whose walls it has to get.

    Yields:
        Joint angles, shape (m, n), and how high they lift, metres.
    """
    ground = obstacles.terrain
    around = obstacles.wide.below(held).max(initial=basket.position[2] + basket.size[2])
    beneath = float(np.maximum(ground.below(held), 0).min(initial=0.0))
    base = max(float(held[:, 2].min()), beneath)
    wanted = float(np.clip(around + _ABOVE - base, _LEAST_LIFT, _MOST_LIFT))
    found = False
    for more in _HIGHER:
        path = _up(obstacles, joints, grasp, points, wanted + more)
        if path is not None:
            found = True
            yield path, wanted + more
    while not found and wanted >= _LEAST_LIFT + _LESS:
        wanted -= _LESS
        path = _up(obstacles, joints, grasp, points, wanted)
        if path is not None:
            found = True
            yield path, wanted


def _up(
    obstacles: Obstacles, joints: Array, grasp: Grasp, points: Array, height: float
) -> Array | None:
    """Up by a height, turning where the grasp asks for it; None out of reach."""
    hand = obstacles.arm.forward(joints)
    poses = line(hand, (0.0, 0.0, height))
    if grasp.turn > 0:
        return _turning(obstacles, joints, hand, poses, grasp, points)
    return straight(obstacles.arm, joints, poses)


def _turning(
    obstacles: Obstacles,
    joints: Array,
    hand: Pose,
    poses: list[Pose],
    grasp: Grasp,
    points: Array,
) -> Array | None:
    """Along poses, the hand turned at each as far as there is room for it and the grasp asks."""
    pivot = hand.inverse().apply(np.array([grasp.middle]))[0]
    # Fingers swapped, the hand's x axis points the other way.
    sense = 1.0 if hand.rotation[:, 0] @ grasp.hand.rotation[:, 0] > 0 else -1.0
    path: list[Array] = []
    angle, last = 0.0, joints
    for pose in poses:
        chosen: Array | None = None
        for more in range(_TURNS_EACH, -1, -1):
            wanted = min(angle + more * _TURN_STEP, grasp.turn)
            found = reaching(obstacles.arm, _turned(pose, pivot, -sense * wanted), last)
            if not found or np.abs(found[0] - last).max() > _JUMP:
                continue
            if more == 0 or obstacles.free_at(found[0], points):
                chosen, angle = found[0], wanted
                break
        if chosen is None:
            return None
        path.append(chosen)
        last = chosen
    return np.array(path)


def _turned(hand: Pose, pivot: Array, angle: float) -> Pose:
    """A hand turned about its x axis around a point in its frame, shape (3,)."""
    turn = Pose((0.0, 0.0, 0.0), (math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0))
    away = pivot - turn.apply(pivot[None])[0]
    return hand @ moved(turn, away)
