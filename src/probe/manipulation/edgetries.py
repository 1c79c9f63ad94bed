"""Which hands get to an edge without touching anything else, and which don't. Knows no arm."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.clearance import BACK_OFF, TIP_CLEARANCE
from probe.manipulation.edgehands import SLIPPERY, EdgeHands, edge_hands
from probe.manipulation.handshape import HandShape
from probe.manipulation.overhangs import Overhangs
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array, Pose, quaternion_of

_BACK = np.array([0.0, 0.02, 0.04, 0.07, BACK_OFF])
_SIDE = 0.002
_SPARE = 0.002
_EVERY, _SOME = 2, 8
_WANTED = 32


@dataclass(frozen=True, eq=False)
class EdgeTry:
    """A hand whose way to an edge was checked.

    Attributes:
        hands: It is one of these.
        index: Which.
        origin: Of its frame, world, metres, shape (3,).
        free: Whether its straight way in touches nothing.
    """

    hands: EdgeHands
    index: int
    origin: Array
    free: bool

    @property
    def place(self) -> tuple[int, float]:
        """Which edge it is to pinch, and how steeply it comes in, radians."""
        return int(self.hands.edges[self.index]), float(self.hands.steeper[self.index])

    @property
    def grasp(self) -> Grasp:
        """The same as a grasp."""
        hands, k = self.hands, self.index
        rotation = hands.rotations[k]
        tilt = float(np.arccos(np.clip(-rotation[2, 2], -1.0, 1.0)))
        x, y, z = (float(v) for v in hands.centres[k])
        pose, opening = Pose.of(self.origin, quaternion_of(rotation)), float(hands.openings[k])
        width, merit = float(hands.thick[k]), float(hands.merits[k])
        # Back to level at most: a hand that points upwards would bring the thing against the arm.
        turn = min(float(hands.steeper[k]), max(np.pi / 2 - tilt, 0.0))
        return Grasp(pose, (x, y, z), opening, width, tilt, merit, turn, by_edge=True)


def edge_tries(
    edges: Overhangs, target: Target, terrain: Terrain, hand: Hand, *, sure: bool
) -> list[EdgeTry]:
    """Hands at a thing's edges, best first, until one gets to each edge at each steepness.

    Only those are sure that rubber holds and that get around the thing at its thickest.
    """
    shape, others = HandShape(hand), terrain.without(target.cells).widened(_SIDE)
    hands = edge_hands(edges, target, hand)
    tried: list[EdgeTry] = []
    taken: set[tuple[int, float]] = set()
    for k in np.argsort(-hands.merits, kind="stable"):
        edge, thick, rotation = int(hands.edges[k]), float(hands.thick[k]), hands.rotations[k]
        same = edge, float(hands.steeper[k])
        risky = thick < edges.thickness or same[1] > SLIPPERY
        if same in taken or (sure and risky):
            continue
        origin = hands.centres[k] - hand.pad_reach(thick) * rotation[:, 2]
        points = shape.whole(float(hands.openings[k]))[::_EVERY] @ rotation.T + origin
        some, approach = points[::_SOME], rotation[:, 2]
        # Most are ruled out by a few points.
        free = all(
            _comes_in(p, approach, edges, edge, thick, target, others) for p in (some, points)
        )
        tried.append(EdgeTry(hands, int(k), origin, free))
        if free:
            taken.add(same)
        if len(taken) >= _WANTED:
            break
    return tried


def free_grasps(tried: Iterable[EdgeTry]) -> list[Grasp]:
    """Grasps by those that get there, best first."""
    return [each.grasp for each in tried if each.free]


def _comes_in(
    points: Array,
    approach: Array,
    edges: Overhangs,
    edge: int,
    thick: float,
    target: Target,
    others: Terrain,
) -> bool:
    """Whether points of the hand, in the world, get there straight, above and below the thing."""
    ways = points - _BACK[:, None, None] * approach
    cells = others.cells(ways[..., :2])
    floors, z = others.heights[cells], ways[..., 2]
    own = target.cells[cells]
    floors = np.where(own, np.maximum(floors, edges.floors[edge]), floors)
    if (z < floors + TIP_CLEARANCE).any():
        return False
    top = np.where(own, target.heights[cells], -np.inf)
    slope = max(float(edges.normals[edge, 2]), 0.5)
    above, below = z > top + _SPARE, z < top - thick / slope - _SPARE
    return bool((above | below).all())
