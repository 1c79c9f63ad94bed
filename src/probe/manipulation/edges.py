"""Grasps of a flat thing by an edge that stands out: one finger above it, one below.

The hand comes from the side, along the surface or somewhat steeper.
"""

from __future__ import annotations

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.edgetries import EdgeTry, edge_tries, free_grasps
from probe.manipulation.overhangs import THICKNESS, overhangs
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array

_WIDE = 0.085
_THIN = 0.045
_FEWEST = 8


def leaning(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Edge grasps of a wide thing that leans on another, which no block does; else none.

    The lowest edge of such a thing lies on the table or low: as thick as that it is supposed. What
    may be thicker than a slab is gripped across first: it mostly is a can, a shoe or a box, whose
    round or sloping top seems to lean.
    """
    return free_grasps(leaning_tries(target, terrain, hand))


def pinches(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
    """Edge grasps, best first, whose straight way in touches nothing seen.

    How thick the thing is can't be seen: it is supposed as thick as there is room for. A level top
    higher than any slab is thick may well be a box's: there no thinner guess is tried.
    """
    return free_grasps(pinch_tries(target, terrain, hand))


def leaning_tries(target: Target, terrain: Terrain, hand: Hand) -> list[EdgeTry]:
    """What leaning() checks."""
    if smallest_width(target.top[:, :2]) < _WIDE:
        return []
    edges = overhangs(target, terrain)
    slab = edges.leans and edges.thickness < _THIN and len(edges.places) >= _FEWEST
    return edge_tries(edges, target, terrain, hand, sure=True) if slab else []


def pinch_tries(target: Target, terrain: Terrain, hand: Hand) -> list[EdgeTry]:
    """What pinches() checks."""
    edges = overhangs(target, terrain)
    if len(edges.places) == 0:
        return []
    tall = float(edges.places[:, 2].min()) > THICKNESS[1]
    return edge_tries(edges, target, terrain, hand, sure=tall and not edges.leans)


def smallest_width(points: Array) -> float:
    """Least extent of points, shape (n, 2), in steps of two degrees, metres; 0 without any."""
    angles = np.radians(np.arange(0, 180, 2))
    along = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float(np.ptp(along, axis=0).min()) if len(points) else 0.0
