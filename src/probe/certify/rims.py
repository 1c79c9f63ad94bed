"""Colours of the rims of things: what shows where one peeks out from under its cover."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from probe.assets.library import Library
from probe.assets.sampling import colours_at, places, spots, topmost
from probe.certify.covers import lies_on_side, on_side
from probe.certify.palettes import shades
from probe.types import Array, Pose

CLEAR = 0.6
"""Share of what shows from which on its main colour is the same in any light."""

_SPOTS = 6000
_DIRECTIONS = 12
_OUTER = 0.2
_CELLS = 40
_SKIN = 0.1


@lru_cache(maxsize=2048)
def rim_colours(library: Library, object_id: str) -> tuple[tuple[float, float, float], ...]:
    """Clear main colours of a thing's outermost fifth, seen from above, on each of its sides.

    It lies as it is laid beneath a cover. CIELAB; sides of many colours are left out.
    """
    mesh = library.body(object_id).mesh
    face, weights = spots(mesh.vertices, mesh.faces, _SPOTS)
    points = places(mesh.vertices, mesh.faces, face, weights)
    if lies_on_side(spec := library[object_id]):
        points = Pose(wxyz=on_side(spec)).apply(points)
    colours = colours_at(mesh, face, weights)
    top = _from_above(points)
    found = list[tuple[float, float, float]]()
    for turn in np.arange(_DIRECTIONS) * 2 * math.pi / _DIRECTIONS:
        out = points[:, :2] @ np.array([np.cos(turn), np.sin(turn)])
        outer = top & (out >= np.quantile(out[top], 1 - _OUTER))
        shade = shades(colours[outer])[0]
        if shade.share >= CLEAR:
            found.append(shade.lab)
    return tuple(found)


def _from_above(points: Array) -> Array:
    """Which points, shape (n, 3), have none of the others far above them."""
    low, high = points.min(axis=0), points.max(axis=0)
    cells = ((points[:, :2] - low[:2]) / (high - low)[:2].max() * (_CELLS - 1)).astype(int)
    cell = cells[:, 0] * _CELLS + cells[:, 1]
    return topmost(cell, points[:, 2], _CELLS * _CELLS, _SKIN * (high - low)[2])
