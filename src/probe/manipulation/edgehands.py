"""Hands that could pinch an edge, one pad above it and one below. Knows no obstacles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.manipulation.overhangs import Overhangs
from probe.manipulation.target import Target
from probe.station.station import Hand
from probe.types import Array

_STEEPER = np.radians([0.0, 14.0, 28.0, 40.0, 52.0])
SLIPPERY = np.radians(45.0)
"""Rubber holds up to here; a rounded rim is held steeper still."""

_DEPTHS = np.array([0.016, 0.0, -0.012, -0.022])
_THINNER = (0.036, 0.024, 0.014, 0.006)
_LOW = 0.012
"""Metres below the surface at which the hand's middle comes in at most: then the lower finger of a
thick thing touches first and lifts it, where the upper one would press it down."""

_GAP = 0.006
"""Metres between each pad and the thing before they close."""

_OPENING_STEP = 0.004


@dataclass(frozen=True, eq=False)
class EdgeHands:
    """Ways to pinch an edge, not yet checked against anything; each array has a row for one.

    Attributes:
        edges: Index of the edge among the overhangs.
        steeper: Angle of the approach to the surface, radians.
        thick: How thick the thing is supposed, metres.
        rotations: world_from_hand, shape (n, 3, 3).
        centres: Middle between the pads, metres, shape (n, 3).
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


def edge_hands(overhangs: Overhangs, target: Target, hand: Hand) -> EdgeHands:
    """Every way to pinch each edge: along the surface and steeper, deeper and less so."""
    thickest = overhangs.thickness
    supposed = np.array([thickest, *(t for t in _THINNER if t < thickest)])
    grids = np.meshgrid(
        np.arange(len(overhangs.places)), _STEEPER, _DEPTHS, supposed, indexing="ij"
    )
    edge, steeper, depth, thick = (one.ravel() for one in grids)
    edge = edge.astype(int)
    out, up, lean = overhangs.outward[edge], overhangs.normals[edge], steeper[:, None]
    approach = -np.cos(lean) * out - np.sin(lean) * up
    closing = np.cos(lean) * up - np.sin(lean) * out
    rotations = np.stack([np.cross(closing, approach), closing, approach], axis=2)
    # Where the pads' faces pass the edge's upper corner, along the closing direction: the upper
    # one's tip dives towards the surface, the lower one passes the lower corner.
    upper = (_GAP + (depth + hand.pad_half[2]) * np.sin(steeper)) / np.cos(steeper)
    lower = thick * np.cos(steeper) + _GAP
    upper = np.maximum(upper, lower - 2 * _LOW)
    held = overhangs.places[edge] + ((upper - lower) / 2)[:, None] * closing
    centres = held + depth[:, None] * approach
    openings = np.ceil((upper + lower) / _OPENING_STEP) * _OPENING_STEP
    merits = _merits(overhangs, target, edge) + 8.0 * depth - 1.0 * steeper
    merits -= np.where(steeper > SLIPPERY, 5.0, 0.0)
    merits -= (30.0 if overhangs.leans else 4.0) * (thickest - thick)
    some = np.flatnonzero(openings < hand.max_opening)
    parts = (edge, steeper, thick, rotations, centres, openings, merits)
    return EdgeHands(*(part[some] for part in parts))


def _merits(overhangs: Overhangs, target: Target, edge: Array) -> Array:
    """Edges with much room below, beside which the middle of the thing doesn't lie, are best."""
    away = target.centre - overhangs.places
    along = np.cross(overhangs.normals, overhangs.outward)
    beside = np.abs((away * along).sum(axis=1))
    room = np.minimum(overhangs.places[:, 2] - overhangs.floors, 0.06)
    return (5.0 * room - 10.0 * beside)[edge]
