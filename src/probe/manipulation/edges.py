"""Grasps of a flat thing by an edge that stands out: one finger above it, one below.

The hand comes from the side, along the surface or somewhat steeper.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.clearance import BACK_OFF, TIP_CLEARANCE
from probe.manipulation.handshape import HandShape
from probe.manipulation.overhangs import Overhangs, overhangs
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array, Pose, quaternion_of

_STEEPER = np.radians([0.0, 14.0, 28.0, 40.0, 52.0])
_SLIPPERY = np.radians(45.0)
"""Rubber holds up to here; a rounded rim is held steeper still."""

_DEPTHS = np.array([0.016, 0.0, -0.012, -0.022])
_THICK = (0.036, 0.024, 0.014, 0.006)
_LOW = 0.012
"""Metres below the surface at which the hand's middle comes in at most: then the lower finger of a
thick thing touches first and lifts it, where the upper one would press it down."""

_KNOWN = 0.030
"""Metres: what is thinner at its lowest edge lies there on the table, and is that thick."""

_WIDE = 0.085
_LEVEL = np.cos(np.radians(5.0))
_GAP = 0.006
"""Metres between each pad and the thing before they close."""

_BACK = np.array([0.0, 0.02, 0.04, 0.07, BACK_OFF])
_SIDE = 0.002
_SPARE = 0.002
_EVERY = 2
_WANTED = 32
_OPENING_STEP = 0.004


def leaning(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """The same of a wide thing that leans on another, which no block does; else none."""
    if smallest_width(target.top[:, :2]) < _WIDE:
        return []
    edges = overhangs(target, terrain)
    if len(edges.places) == 0 or np.median(edges.normals[:, 2]) > _LEVEL:
        return []
    return _pinches(edges, target, terrain, hand)


def pinches(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Grasps by an edge, best first, whose straight way in touches nothing seen.

    How thick the thing is can't be seen: it is supposed as thick as there is room for.
    """
    edges = overhangs(target, terrain)
    return _pinches(edges, target, terrain, hand) if len(edges.places) else []


def smallest_width(points: Array) -> float:
    """Least extent of points, shape (n, 2), in steps of two degrees, metres; 0 without any."""
    angles = np.radians(np.arange(0, 180, 2))
    along = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float(np.ptp(along, axis=0).min()) if len(points) else 0.0


def _pinches(edges: Overhangs, target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    shape, others = HandShape(hand), terrain.without(target.cells).widened(_SIDE)
    options = _options(edges, target, hand)
    found: list[Grasp] = []
    taken: set[tuple[int, int]] = set()
    for k in np.argsort(-options.merits, kind="stable"):
        edge, thick, rotation = int(options.edges[k]), float(options.thick[k]), options.rotations[k]
        same = edge, round(100 * float(options.steeper[k]))
        if same in taken:
            continue
        origin = options.centres[k] - hand.pad_reach(thick) * rotation[:, 2]
        points = shape.whole(float(options.openings[k]))[::_EVERY] @ rotation.T + origin
        if _comes_in(points, rotation[:, 2], edges, edge, thick, target, others):
            found.append(_grasp(options, int(k), origin))
            taken.add(same)
        if len(found) >= _WANTED:
            break
    return found


@dataclass(frozen=True, eq=False)
class _Options:
    """Ways to pinch an edge, not yet checked; each array has a row for one.

    Attributes:
        edges: Index of the edge.
        steeper: Angle of the approach to the surface, radians.
        thick: Supposed thickness, metres.
        rotations: world_from_hand.
        centres: Middle between the pads, metres.
        openings: How far apart the pads come in, metres.
        merits: Higher is better.
    """

    edges: Array
    steeper: Array
    thick: Array
    rotations: Array
    centres: Array
    openings: Array
    merits: Array


def _options(edges: Overhangs, target: Target, hand: Hand) -> _Options:
    supposed = np.array([edges.thickness, *(t for t in _THICK if t < edges.thickness)])
    count = np.arange(len(edges.places))
    grids = np.meshgrid(count, _STEEPER, _DEPTHS, supposed, indexing="ij")
    edge, steeper, depth, thick = (one.ravel() for one in grids)
    edge = edge.astype(int)
    out, up, lean = edges.outward[edge], edges.normals[edge], steeper[:, None]
    approach = -np.cos(lean) * out - np.sin(lean) * up
    closing = np.cos(lean) * up - np.sin(lean) * out
    rotations = np.stack([np.cross(closing, approach), closing, approach], axis=2)
    # Where the pads' faces pass the edge's upper corner, along the closing direction: the upper
    # one's tip dives towards the surface, the lower one passes the lower corner.
    upper = (_GAP + (depth + hand.pad_half[2]) * np.sin(steeper)) / np.cos(steeper)
    lower = thick * np.cos(steeper) + _GAP
    upper = np.maximum(upper, lower - 2 * _LOW)
    held = edges.places[edge] + ((upper - lower) / 2)[:, None] * closing
    centres = held + depth[:, None] * approach
    openings = np.ceil((upper + lower) / _OPENING_STEP) * _OPENING_STEP
    away = target.centre - edges.places[edge]
    beside = np.abs((away * np.cross(up, out)).sum(axis=1))
    room = np.minimum(edges.places[:, 2] - edges.floors, 0.06)[edge]
    merits = 5.0 * room - 10.0 * beside + 8.0 * depth
    merits -= 1.0 * steeper + np.where(steeper > _SLIPPERY, 5.0, 0.0)
    merits += np.where(edges.thickness < _KNOWN, 30.0, 4.0) * (thick - edges.thickness)
    some = np.flatnonzero(openings < hand.max_opening)
    parts = (edge, steeper, thick, rotations, centres, openings, merits)
    return _Options(*(part[some] for part in parts))


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


def _grasp(options: _Options, index: int, origin: Array) -> Grasp:
    rotation = options.rotations[index]
    tilt = float(np.arccos(np.clip(-rotation[2, 2], -1.0, 1.0)))
    x, y, z = (float(v) for v in options.centres[index])
    width, merit = float(options.thick[index]), float(options.merits[index])
    pose, opening = Pose.of(origin, quaternion_of(rotation)), float(options.openings[index])
    return Grasp(pose, (x, y, z), opening, width, tilt, merit)
