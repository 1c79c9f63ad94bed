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
from probe.types import Array, Pose, Vector3, quaternion_of

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


@dataclass(frozen=True, eq=False)
class Fitting:
    """Hands that were to fit around a target with so much room, and how far each got.

    Attributes:
        room: How much room they were to have, and among what.
        which: Index of each among all hands that were proposed, shape (n,); the tips of those that
            are missing are free at no depth.
        hands: As deep as they may go, and closed on the target.
        merits: How good each would be, shape (n,); -inf where a pad would touch nothing, or where
            the target is too wide.
        checked: Indices into `hands` of those whose way in was checked, best first, shape (m,).
        free: Whether that way is free, bool, shape (m,).
    """

    room: Clearance
    which: Array
    hands: HandPoses
    merits: Array
    checked: Array
    free: Array

    def grasp(self, index: int) -> Grasp:
        """One of the hands as a grasp."""
        return grasp_of(self.room, self.hands, index, float(self.merits[index]))


def propose(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Grasps of a target, best first, whose straight way in touches nothing seen."""
    _, found = fittings(target, terrain, hand)
    grasps = [fit.grasp(int(index)) for fit in found for index in fit.checked[fit.free]]
    return sorted(grasps, key=lambda grasp: -grasp.merit)


def fittings(target: Target, terrain: Terrain, hand: Hand) -> tuple[HandPoses, list[Fitting]]:
    """All hands that could close on a target, and how they fit at each margin that was tried.

    Tight fits are only looked for where there are few comfortable ones.
    """
    shape = HandShape(hand)
    hands = around(opposed(target, hand.max_opening - _SPARE))
    found: list[Fitting] = []
    for number, margin in enumerate(MARGINS):
        room = Clearance.of(shape, margin, terrain, target)
        found.append(_fitting(room, hands, target, -_TIGHT_COST * number))
        if sum(int(fit.free.sum()) for fit in found) >= _WANTED:
            break
    return hands, found


def _fitting(room: Clearance, hands: HandPoses, target: Target, bonus: float) -> Fitting:
    """How hands fit at one margin; the best are checked until enough do."""
    hands, which = room.deepest(hands)
    hands, merits = close(hands, target, room.shape.hand.pad_half, room.shape.hand.max_opening / 2)
    merits = merits + bonus - 0.5 * (hands.tilts / np.radians(60.0)) ** 2
    merits -= 0.4 * (hands.widths / room.shape.hand.max_opening) ** 2
    merits[hands.widths > room.shape.hand.max_opening - _SPARE] = -np.inf
    order = np.argsort(-merits, kind="stable")
    order = order[np.isfinite(merits[order])]
    free = np.zeros(0, bool)
    while len(free) < len(order) and free.sum() < _WANTED:
        some = order[len(free) : len(free) + _CHUNK]
        free = np.append(free, room.way_free(hands[some]))
    return Fitting(room, which, hands, merits, order[: len(free)], free)


def grasp_of(room: Clearance, hands: HandPoses, index: int, merit: float) -> Grasp:
    """One of several hands as a grasp."""
    width, rotation = float(hands.widths[index]), hands.rotations[index]
    origin = hands.centres[index] - room.shape.hand.pad_reach(width) * rotation[:, 2]
    opening = float(room.openings(hands.widths[index]))
    pose = Pose.of(origin, quaternion_of(rotation))
    x, y, z = (float(v) for v in hands.centres[index])
    return Grasp(pose, (x, y, z), opening, width, float(hands.tilts[index]), merit)
