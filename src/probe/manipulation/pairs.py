"""Opposite places on a thing's sides, and the hands that could close on them. Knows no obstacles.

Antipodal: each side's normal lies within the friction cone around the line that joins the two
(Nguyen, "Constructing force-closure grasps", IJRR 7(3), 1988).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.manipulation.target import Target
from probe.types import Array

CONE = np.cos(np.radians(35.0))
"""Least cosine between a normal and the closing line; rubber holds up to 45 degrees."""

TILTS = np.radians([0.0, -20.0, 20.0, -40.0, 40.0, -60.0, 60.0])
"""Turns of the hand about its closing axis, from as upright as the axis allows."""

MAX_TILT = np.radians(61.0)

_FIRST, _SECOND = 160, 600
_KEPT = 160
_BIN = np.array([0.012, 0.012, 0.02])
_TURN_BINS = 9
_AXIS_SLOPE = 0.5


@dataclass(frozen=True, eq=False)
class Pairs:
    """Opposite places.

    Attributes:
        middles: Between the two places, metres, shape (n, 3).
        axes: Unit closing directions, shape (n, 3).
        widths: Distance of the two along the axis, metres, shape (n,).
    """

    middles: Array
    axes: Array
    widths: Array


@dataclass(frozen=True, eq=False)
class HandPoses:
    """Ways to put the pads around a pair, not yet checked against anything.

    Attributes:
        rotations: world_from_hand, shape (n, 3, 3).
        centres: Middle between the pads when they touch, metres, shape (n, 3).
        widths: Distance of the pads then, metres, shape (n,).
        tilts: Angle of the hand from straight down, radians, shape (n,).
    """

    rotations: Array
    centres: Array
    widths: Array
    tilts: Array

    def __getitem__(self, chosen: Array) -> HandPoses:
        return HandPoses(
            self.rotations[chosen], self.centres[chosen], self.widths[chosen], self.tilts[chosen]
        )


def opposed(target: Target, max_width: float) -> Pairs:
    """The best pair of places for each spot and direction, most promising first."""
    first, second = _every(len(target.walls), _FIRST), _every(len(target.walls), _SECOND)
    p, n = target.walls[first][:, None], target.normals[first][:, None]
    q, m = target.walls[second][None], target.normals[second][None]
    line = q - p
    length = np.maximum(np.linalg.norm(line, axis=2), 1e-6)
    line = line / length[..., None]
    into, out = -(n * line).sum(axis=2), (m * line).sum(axis=2)
    good = (into > CONE) & (out > CONE) & (length < max_width)
    i, j = np.nonzero(good)
    axes: Array = m[0, j] - n[i, 0]
    axes = axes / np.linalg.norm(axes, axis=1, keepdims=True)
    axes = np.where(axes[:, 1:2] < 0, -axes, axes)
    middles = (p[i, 0] + q[0, j]) / 2
    away = np.linalg.norm((middles - target.centre)[:, :2], axis=1)
    merit = np.minimum(into[i, j], out[i, j]) - 4.0 * away
    widths = np.abs(((q[0, j] - p[i, 0]) * axes).sum(axis=1))
    usable = np.flatnonzero(np.abs(axes[:, 2]) < _AXIS_SLOPE)
    best = usable[np.argsort(-merit[usable], kind="stable")]
    best = best[_distinct(middles[best], axes[best])][:_KEPT]
    return Pairs(middles[best], axes[best], widths[best])


def around(pairs: Pairs) -> HandPoses:
    """Each pair approached upright and tilted about its axis."""
    axes = np.repeat(pairs.axes, len(TILTS), axis=0)
    turns = np.tile(TILTS, len(pairs.axes))[:, None]
    down = np.array([0.0, 0.0, -1.0])
    upright = down - axes * (axes @ down)[:, None]
    upright /= np.linalg.norm(upright, axis=1, keepdims=True)
    approach = upright * np.cos(turns) + np.cross(axes, upright) * np.sin(turns)
    rotations = np.stack([np.cross(axes, approach), axes, approach], axis=2)
    tilts = np.arccos(np.clip(-approach[:, 2], -1.0, 1.0))
    hands = HandPoses(
        rotations,
        np.repeat(pairs.middles, len(TILTS), axis=0),
        np.repeat(pairs.widths, len(TILTS)),
        tilts,
    )
    return hands[tilts <= MAX_TILT]


def _every(count: int, wanted: int) -> Array:
    """At most so many indices, evenly spread."""
    return np.unique(np.linspace(0, count - 1, min(count, wanted)).astype(int))


def _distinct(middles: Array, axes: Array) -> Array:
    """Indices of the first of each small region and direction."""
    turn = np.floor(np.arctan2(axes[:, 1], axes[:, 0]) / np.pi * _TURN_BINS)
    bins = np.column_stack([np.floor(middles / _BIN), turn])
    return np.sort(np.unique(bins, axis=0, return_index=True)[1])
