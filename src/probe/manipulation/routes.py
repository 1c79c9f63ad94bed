"""Joint paths to a grasp, up with what was grasped, over the basket and home. Moves nothing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.clearance import BACK_OFF
from probe.manipulation.handshape import HandShape
from probe.manipulation.kinematics import either_way, line, moved, reaching, straight, turned
from probe.manipulation.lifting import lifts
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.scene.setup import Basket
from probe.station.station import Arm
from probe.types import Array

_HOVERS = (0.0, 0.08, 0.16, 0.24)
_BRANCHES = 3
_ABOVE = 0.05
_LOWERINGS = (0.12, 0.08, 0.04)
_TURNS = np.radians([0, -30, 30, -60, 60, -90, 90, -120, 120, 150, 180])
_THINNED = 3


@dataclass(frozen=True, eq=False)
class WayIn:
    """How the arm gets from its parked place around something.

    Attributes:
        transit: Joint angles to the beginning of the approach, shape (m, n).
        approach: Straight on to the grasp, shape (k, n).
    """

    transit: Array
    approach: Array


@dataclass(frozen=True, eq=False)
class WayOut:
    """How the arm brings what it holds to the basket.

    Attributes:
        lift: Up, shape (m, n).
        carry: To above the basket, shape (k, n).
        lower: Into the basket, shape (l, n); empty where there is no room.
    """

    lift: Array
    carry: Array
    lower: Array


def way_in(
    arm: Arm, start: Array, obstacles: Obstacles, grasp: Grasp, shape: HandShape
) -> WayIn | None:
    """A free path to a grasp; None if it is out of reach or there is none."""
    points = shape.whole(grasp.opening)[::_THINNED]
    for pose in either_way(grasp.hand):
        for joints in reaching(arm, pose, start)[:_BRANCHES]:
            if not obstacles.arm_free(joints):
                continue
            back = straight(arm, joints, line(pose, -BACK_OFF * pose.rotation[:, 2]))
            if back is None or not obstacles.arm_free(back[-1]):
                continue
            transit = over(arm, start, back[-1], obstacles, points)
            if transit is not None:
                return WayIn(transit, np.vstack([back[-2::-1], joints]))
    return None


def home(arm: Arm, obstacles: Obstacles, joints: Array, points: Array) -> Array:
    """A path back to the parked place, free of what is known wherever there is such a path."""
    path = over(arm, arm.parked, joints, obstacles, points)
    return np.array([arm.parked]) if path is None else np.vstack([path[-2::-1], arm.parked])


def way_out(
    obstacles: Obstacles,
    joints: Array,
    grasp: Grasp,
    target: Target,
    basket: Basket,
    points: Array,
) -> WayOut | None:
    """A path that lifts, carries and lowers; None if the arm can't lift that far.

    Args:
        obstacles: All but the target.
        joints: The arm's, closed on the target.
        grasp: How it holds the target.
        target: What it holds.
        basket: The basket.
        points: On the hand, in its frame, shape (k, 3).
    """
    held = np.concatenate([target.top, target.walls])
    held = held[:: max(1, len(held) // 150)]
    # Things that are brushed give way; a hand that meets the forearm is stuck there.
    brushing: tuple[Array, Array, Array] | None = None
    folded: tuple[Array, Array, Array] | None = None
    for turn in sorted({grasp.turn, 0.0}, reverse=True):
        few = points if turn > 0 else points[::_THINNED]
        ways_up = lifts(obstacles, joints, replace(grasp, turn=turn), held, few, basket)
        for lift, goal, carried in _carries(obstacles, ways_up, held, few, target, basket):
            unfolded = obstacles.unfolded(goal, points)
            if unfolded and obstacles.free(np.array([lift[-1], goal]), carried):
                return WayOut(lift, goal[None], _lower(obstacles, goal, carried))
            # Turned fingers come near the forearm, so none of these ways is risked.
            if turn == 0 and unfolded:
                brushing = brushing or (lift, goal, carried)
            elif turn == 0:
                folded = folded or (lift, goal, carried)
    fallback = brushing or folded
    if fallback is None:
        return None
    lift, goal, carried = fallback
    return WayOut(lift, goal[None], _lower(obstacles, goal, carried))


def _carries(
    obstacles: Obstacles,
    ways_up: Iterator[tuple[Array, float]],
    held: Array,
    points: Array,
    target: Target,
    basket: Basket,
) -> Iterator[tuple[Array, Array, Array]]:
    """Lifts, joint angles above the basket, and points of hand and held thing, hand's frame."""
    arm, above = obstacles.arm, _top(obstacles.terrain, basket) + _ABOVE
    for lift, height in ways_up:
        # The hand may turn as it rises; what it holds is supposed to stay level.
        back, risen = arm.forward(lift[-1]).inverse(), np.array([0.0, 0.0, height])
        carried = np.concatenate([points, back.apply(held + risen)])
        centre = back.apply(target.centre[None] + risen)[0]
        for goal in _goals(arm, lift[-1], centre, carried, basket, above):
            yield lift, goal, carried


def _top(terrain: Terrain, basket: Basket) -> float:
    """Height of the basket's walls, or of what lies in it if that is more, metres."""
    middle, half = np.array(basket.position[:2]), np.array(basket.size[:2]) / 2
    rows, columns = terrain.cells(np.array([middle - half, middle + half]))
    inside = terrain.heights[rows[0] : rows[1] + 1, columns[0] : columns[1] + 1]
    return max(basket.position[2] + basket.size[2], float(inside.max()))


def _goals(
    arm: Arm, joints: Array, centre: Array, carried: Array, basket: Basket, above: float
) -> Sequence[Array]:
    """Joint angles that hold the target's centre so high over the basket, nearest first."""
    hand = arm.forward(joints)
    lowest = float(hand.apply(carried)[:, 2].min())
    rise = max(0.0, above - lowest)
    found: list[Array] = []
    for angle in _TURNS:
        pose = turned(hand, float(angle))
        over = np.array(basket.position) - pose.apply(centre[None])[0]
        lifted = moved(pose, (over[0], over[1], rise))
        found += reaching(arm, lifted, joints)[:1]
    return sorted(found, key=lambda goal: float(np.abs(goal - joints).max()))


def _lower(obstacles: Obstacles, joints: Array, carried: Array) -> Array:
    hand = obstacles.arm.forward(joints)
    for depth in _LOWERINGS:
        path = straight(obstacles.arm, joints, line(hand, (0.0, 0.0, -depth)))
        if path is not None and obstacles.free_at(path[-1], carried):
            return path
    return np.zeros((0, len(joints)))


def over(arm: Arm, start: Array, goal: Array, obstacles: Obstacles, points: Array) -> Array | None:
    """A free path from a start to a goal, both included, by way of a place above the goal.

    Returns:
        Joint angles, shape (m, n), or None if every such path meets something known.
    """
    for height in _HOVERS:
        path = np.array([start, goal])
        if height > 0:
            rise = straight(arm, goal, line(arm.forward(goal), (0.0, 0.0, height)))
            if rise is None:
                return None
            path = np.vstack([start[None], rise[::-1], goal[None]])
        if obstacles.free(path, points):
            return path
    return None
