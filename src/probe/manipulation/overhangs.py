"""Where the edge of a flat thing stands out over something lower. Knows no gripper.

A camera above sees no undersides: that there is room under an edge is guessed from how far the
height falls beside it. A solid block looks the same, so a finger that goes there may be stopped.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.types import Array

LEAST_ROOM = 0.012
"""Metres under an edge below which no finger fits there."""

THICKNESS = 0.004, 0.050
"""Least and greatest thickness that is guessed, metres."""

_THIN = 0.012
_BLUR = 3.0
_BESIDE = np.array([0.006, 0.010, 0.015, 0.020, 0.028])
_ASIDE = np.array([-0.010, 0.0, 0.010])
_APART = 0.012
_PATCH, _ROUGHNESS, _OFF_PLANE = 0.022, 0.002, 0.004
_FEWEST = 30
_LEVEL = np.cos(np.radians(5.0))
_STEEPEST = np.cos(np.radians(50.0))


@dataclass(frozen=True, eq=False)
class Overhangs:
    """Places on the edges of a thing with room below.

    Attributes:
        places: On the edge at the height of the surface, metres, shape (n, 3).
        outward: Unit directions out of the thing along its surface, shape (n, 3).
        normals: Unit normals of the surface there, upwards, shape (n, 3).
        floors: Highest that stands just beside the edge, metres, shape (n,).
        thickness: What it is at most by the lowest step down from it, metres.
    """

    places: Array
    outward: Array
    normals: Array
    floors: Array
    thickness: float

    @property
    def leans(self) -> bool:
        """Whether the thing leans on another, as no block does that stands on the table."""
        return len(self.normals) > 0 and bool(np.median(self.normals[:, 2]) < _LEVEL)


def overhangs(target: Target, terrain: Terrain) -> Overhangs:
    """Edges of what shows of a thing with enough room below, evenly spread."""
    places, level = _border(target, terrain)
    some = _spread(places)
    normals, smooth = _planes(target.top, places[some])
    some, normals = some[smooth], normals[smooth]
    places, level = places[some], level[some]
    if len(places) == 0:
        return Overhangs(places, level, normals, np.zeros(0), THICKNESS[0])
    # Nothing reaches below the table, so where it is lowest tells how thick it may be.
    thickness = float(np.clip(np.percentile(places[:, 2] / normals[:, 2], 2), *THICKNESS))
    floors = _floors(target, terrain, places, level)
    good = places[:, 2] - floors > LEAST_ROOM + min(thickness, _THIN)
    outward = level - (level * normals).sum(axis=1, keepdims=True) * normals
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    return Overhangs(places[good], outward[good], normals[good], floors[good], thickness)


def _border(target: Target, terrain: Terrain) -> tuple[Array, Array]:
    """Cells at the edge of what shows: their points and level outward unit directions, (n, 3)."""
    rows, columns = np.nonzero(target.cells & ~ndimage.binary_erosion(target.cells))
    blurred = ndimage.gaussian_filter(target.cells.astype(float), _BLUR)
    ways = -np.stack([np.gradient(blurred, axis=0), np.gradient(blurred, axis=1)], axis=-1)
    level = ways[rows, columns]
    length = np.linalg.norm(level, axis=1)
    kept = length > 0
    level = level[kept] / length[kept, None]
    rows, columns = rows[kept], columns[kept]
    places = np.column_stack([terrain.centres(rows, columns), target.heights[rows, columns]])
    return places, np.column_stack([level, np.zeros(len(level))])


def _floors(target: Target, terrain: Terrain, places: Array, level: Array) -> Array:
    """The highest that stands just beside each place, metres, shape (n,)."""
    aside = np.column_stack([-level[:, 1], level[:, 0], level[:, 2]])
    near = places + _BESIDE[:, None, None] * level
    points = near + _ASIDE[:, None, None, None] * aside
    own = target.cells[terrain.cells(points[..., :2])]
    return np.where(own, 0.0, terrain.below(points)).max(axis=(0, 1))


def _spread(places: Array) -> Array:
    """Indices of the first place of each small square."""
    bins = np.floor(places[:, :2] / _APART)
    return np.sort(np.unique(bins, axis=0, return_index=True)[1])


def _planes(points: Array, places: Array) -> tuple[Array, Array]:
    """Upward normals of the surface by each place, (n, 3), and whether it can be pinched, (n,)."""
    normals, smooth = np.tile([0.0, 0.0, 1.0], (len(places), 1)), np.zeros(len(places), bool)
    for k, place in enumerate(places):
        patch = points[np.linalg.norm(points - place, axis=1) < _PATCH]
        if len(patch) < _FEWEST:
            continue
        _, spread, axes = np.linalg.svd(patch - patch.mean(axis=0), full_matrices=False)
        normals[k] = axes[2] * (1.0 if axes[2, 2] > 0 else -1.0)
        # What shows of a side lies below the plane of the top.
        below = abs(float((place - patch.mean(axis=0)) @ normals[k])) > _OFF_PLANE
        rough = spread[2] / np.sqrt(len(patch)) >= _ROUGHNESS
        smooth[k] = not below and not rough and normals[k, 2] > _STEEPEST
    return normals, smooth
