"""Grasps that a mask's points suggest and whose way in is free. Knows no arm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from probe.manipulation.clearance import MARGINS, Clearance
from probe.manipulation.closing import close
from probe.manipulation.handshape import HandShape
from probe.manipulation.pairs import HandPoses, around, opposed
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Pose, Vector3, quaternion_of

_SPARE = 0.006
_WANTED = 16
_CHUNK = 32
_TIGHT_COST = 0.3


@dataclass(frozen=True)
class Grasp:
    """A way to hold something.

    Attributes:
        hand: world_from_hand when the pads touch.
        middle: Between the pads then, world, metres.
        opening: Distance of the pads on the way in, metres.
        width: Distance of the pads when they touch, metres.
        tilt: Angle of the hand from straight down, radians.
        merit: Higher is better; comparable within one call only.
        turn: Radians by which the hand should turn back about its x axis, around the middle, while
            it lifts, so that the pads come to lie along what they hold.
        by_edge: Whether the pads come above and below an edge, not on two sides.
    """

    hand: Pose
    middle: Vector3
    opening: float
    width: float
    tilt: float
    merit: float
    turn: float = 0.0
    by_edge: bool = False


Planner = Callable[[Target, Terrain, Hand], list[Grasp]]
"""Finds grasps of a target among what a terrain shows, best first; `propose` is one."""


def propose(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Grasps of a target, best first, whose straight way in touches nothing seen.

    Tight fits are only looked for where there are few comfortable ones.
    """
    shape = HandShape(hand)
    hands = around(opposed(target, hand.max_opening - _SPARE))
    found: list[Grasp] = []
    for number, margin in enumerate(MARGINS):
        room = Clearance.of(shape, margin, terrain, target)
        found += _fitting(room, hands, target, -_TIGHT_COST * number)
        if len(found) >= _WANTED:
            break
    return sorted(found, key=lambda grasp: -grasp.merit)


def _fitting(room: Clearance, hands: HandPoses, target: Target, bonus: float) -> list[Grasp]:
    """The best few grasps that fit at one margin."""
    hands = room.deepest(hands)
    hands, merits = close(hands, target, room.shape.hand.pad_half, room.shape.hand.max_opening / 2)
    merits = merits + bonus - 0.5 * (hands.tilts / np.radians(60.0)) ** 2
    merits -= 0.4 * (hands.widths / room.shape.hand.max_opening) ** 2
    merits[hands.widths > room.shape.hand.max_opening - _SPARE] = -np.inf
    order = np.argsort(-merits, kind="stable")
    order = order[np.isfinite(merits[order])]
    found: list[Grasp] = []
    for start in range(0, len(order), _CHUNK):
        some = order[start : start + _CHUNK]
        for index in some[room.way_free(hands[some])]:
            found.append(grasp_of(room, hands, int(index), float(merits[index])))
        if len(found) >= _WANTED:
            break
    return found


def grasp_of(room: Clearance, hands: HandPoses, index: int, merit: float) -> Grasp:
    """One of several hands as a grasp."""
    width, rotation = float(hands.widths[index]), hands.rotations[index]
    origin = hands.centres[index] - room.shape.hand.pad_reach(width) * rotation[:, 2]
    opening = float(room.openings(hands.widths[index]))
    pose = Pose.of(origin, quaternion_of(rotation))
    x, y, z = (float(v) for v in hands.centres[index])
    return Grasp(pose, (x, y, z), opening, width, float(hands.tilts[index]), merit)
