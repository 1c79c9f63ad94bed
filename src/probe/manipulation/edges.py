"""Grasps of a flat thing by an edge that stands out: one finger above it, one below.

The hand comes from the side, along the surface or somewhat steeper.
"""

from __future__ import annotations

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.clearance import BACK_OFF, TIP_CLEARANCE
from probe.manipulation.handshape import HandShape
from probe.manipulation.overhangs import Overhangs, overhangs
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array, Pose, quaternion_of

_STEEPER = np.radians([0.0, 12.0, 24.0, 36.0])
_DEPTHS = np.array([0.018, 0.006, -0.008])
_OPENINGS = (0.028, 0.040, 0.056, 0.072)
_BACK = np.array([0.0, 0.02, 0.04, 0.07, BACK_OFF])
_SIDE = 0.002
_SPARE = 0.002
_EVERY = 2
_WANTED = 32


def pinches(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Grasps by an edge, best first, whose straight way in touches nothing seen."""
    edges = overhangs(target, terrain)
    if len(edges.places) == 0:
        return []
    shape, others = HandShape(hand), terrain.without(target.cells).widened(_SIDE)
    rotations, centres, merits, number = _hands(edges, target)
    found: list[Grasp] = []
    for k in np.argsort(-merits, kind="stable"):
        edge, rotation, centre = int(number[k]), rotations[k], centres[k]
        for opening in _OPENINGS:
            width = edges.thickness
            origin = centre - hand.pad_reach(width) * rotation[:, 2]
            points = shape.whole(opening)[::_EVERY] @ rotation.T + origin
            if _comes_in(points, rotation[:, 2], edges, edge, target, others):
                tilt = float(np.arccos(np.clip(-rotation[2, 2], -1.0, 1.0)))
                x, y, z = (float(v) for v in centre)
                pose = Pose.of(origin, quaternion_of(rotation))
                found.append(Grasp(pose, (x, y, z), opening, width, tilt, float(merits[k])))
                break
        if len(found) >= _WANTED:
            break
    return found


def _hands(edges: Overhangs, target: Target) -> tuple[Array, Array, Array, Array]:
    """Rotations, middles between the pads, merits, and which edge each one holds."""
    count = len(edges.places)
    edge, steep, depth = (
        one.ravel()
        for one in np.meshgrid(
            np.arange(count), np.arange(len(_STEEPER)), np.arange(len(_DEPTHS)), indexing="ij"
        )
    )
    out, up = edges.outward[edge], edges.normals[edge]
    lean = _STEEPER[steep][:, None]
    approach = -np.cos(lean) * out - np.sin(lean) * up
    closing = np.cos(lean) * up - np.sin(lean) * out
    rotations = np.stack([np.cross(closing, approach), closing, approach], axis=2)
    held = edges.places[edge] - edges.thickness / 2 * up
    centres = held + _DEPTHS[depth][:, None] * approach
    away = target.centre - edges.places[edge]
    beside = np.abs((away * np.cross(up, out)).sum(axis=1))
    room = np.minimum(edges.places[:, 2] - edges.floors, 0.06)[edge]
    merits = 5.0 * room - 10.0 * beside - 0.6 * lean[:, 0] + 5.0 * _DEPTHS[depth]
    return rotations, centres, merits, edge


def _comes_in(
    points: Array, approach: Array, edges: Overhangs, edge: int, target: Target, others: Terrain
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
    above, below = z > top + _SPARE, z < top - edges.thickness / slope - _SPARE
    return bool((above | below).all())
