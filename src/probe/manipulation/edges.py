"""Grasps of a flat thing by an edge that stands out: one finger above it, one below.

The hand comes from the side, along the surface or somewhat steeper.
"""

from __future__ import annotations

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.clearance import BACK_OFF, TIP_CLEARANCE
from probe.manipulation.edgehands import SLIPPERY, EdgeHands, edge_hands
from probe.manipulation.handshape import HandShape
from probe.manipulation.overhangs import THICKNESS, Overhangs, overhangs
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array, Pose, quaternion_of

_WIDE = 0.085
_BACK = np.array([0.0, 0.02, 0.04, 0.07, BACK_OFF])
_SIDE = 0.002
_SPARE = 0.002
_EVERY, _SOME = 2, 8
_WANTED = 32
_FEWEST = 8


def leaning(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Edge grasps of a wide thing that leans on another, which no block does; else none.

    The lowest edge of such a thing lies on the table or low: as thick as that it is supposed.
    """
    if smallest_width(target.top[:, :2]) < _WIDE:
        return []
    edges = overhangs(target, terrain)
    few = len(edges.places) < _FEWEST
    return _pinches(edges, target, terrain, hand, sure=True) if edges.leans and not few else []


def pinches(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Edge grasps, best first, whose straight way in touches nothing seen.

    How thick the thing is can't be seen: it is supposed as thick as there is room for. A level top
    higher than any slab is thick may well be a box's: there no thinner guess is tried.
    """
    edges = overhangs(target, terrain)
    if len(edges.places) == 0:
        return []
    tall = float(edges.places[:, 2].min()) > THICKNESS[1]
    return _pinches(edges, target, terrain, hand, sure=tall and not edges.leans)


def smallest_width(points: Array) -> float:
    """Least extent of points, shape (n, 2), in steps of two degrees, metres; 0 without any."""
    angles = np.radians(np.arange(0, 180, 2))
    along = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float(np.ptp(along, axis=0).min()) if len(points) else 0.0


def _pinches(
    edges: Overhangs, target: Target, terrain: Terrain, hand: Hand, *, sure: bool
) -> list[Grasp]:
    """The best hand that gets there for each edge and steepness.

    Only those are sure that rubber holds and that get around the thing at its thickest.
    """
    shape, others = HandShape(hand), terrain.without(target.cells).widened(_SIDE)
    hands = edge_hands(edges, target, hand)
    found: list[Grasp] = []
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
        if all(_comes_in(p, approach, edges, edge, thick, target, others) for p in (some, points)):
            found.append(_grasp(hands, int(k), origin))
            taken.add(same)
        if len(found) >= _WANTED:
            break
    return found


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


def _grasp(hands: EdgeHands, index: int, origin: Array) -> Grasp:
    rotation = hands.rotations[index]
    tilt = float(np.arccos(np.clip(-rotation[2, 2], -1.0, 1.0)))
    x, y, z = (float(v) for v in hands.centres[index])
    pose, opening = Pose.of(origin, quaternion_of(rotation)), float(hands.openings[index])
    width, merit = float(hands.thick[index]), float(hands.merits[index])
    # Back to level at most: a hand that points upwards would bring the thing against the arm.
    turn = min(float(hands.steeper[index]), max(np.pi / 2 - tilt, 0.0))
    return Grasp(pose, (x, y, z), opening, width, tilt, merit, turn, by_edge=True)
