"""Things alike in all but their paint, and the sides on which even that is alike.

Where no more than such a side shows, nothing tells which of the two lies there: neither its shape
nor how it lies nor its colours.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.assets.colour.names import lab
from probe.assets.library import Library
from probe.assets.mesh.lattice import colours_at, places, spots, topmost
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.spec import ObjectSpec
from probe.generation.covers import lies_on_side, on_side
from probe.generation.palettes import shades
from probe.types import Array, Pose

_SPOTS = 6000
_DIRECTIONS = 12
_OUTER = 0.1
"""Share of what is seen from above that a side is: what is farthest out."""

ALIKE = 0.95
"""Least share of a side, or of what shows, on which paints are alike."""

_GRAIN = 5.0
"""CIEDE2000 by which paints that are alike differ at most, spot by spot: textures have a grain of
their own."""

_CELLS = 40
_SKIN = 0.1


@dataclass(frozen=True, eq=False)
class PaintTwins:
    """Two things of one shape and mass, alike on some sides, with main colours of other names.

    Attributes:
        pair: The two.
        angles: Which way the sides look on which they are alike, on things that aren't turned
            about the vertical, radians from x, shape (n,), n over 0.
        patches: Main colours of those sides, by texture, CIELAB, shape (n, 3).
    """

    pair: tuple[ObjectSpec, ObjectSpec]
    angles: Array
    patches: Array


def paint_twins(library: Library, pool: Iterable[ObjectSpec]) -> tuple[PaintTwins, ...]:
    """All that there are among some things, in the pool's order."""
    kin = defaultdict[tuple[object, ...], list[ObjectSpec]](list)
    for spec in pool:
        kin[spec.category, spec.size, spec.mass, spec.friction].append(spec)
    return tuple(_twins(library, (group for group in kin.values() if len(group) > 1)))


def _twins(library: Library, groups: Iterable[list[ObjectSpec]]) -> Iterator[PaintTwins]:
    for group in groups:
        meshes = {spec.id: library.body(spec.id).mesh for spec in group}
        for one, other in combinations(group, 2):
            mine, its = meshes[one.id], meshes[other.id]
            if one.colours[0] != other.colours[0] and _same_shape(mine, its):
                angles, patches = _shared_sides(one, mine, its)
                if len(angles):
                    yield PaintTwins((one, other), angles, patches)


def _same_shape(one: TexturedMesh, other: TexturedMesh) -> bool:
    return np.array_equal(one.vertices, other.vertices) and np.array_equal(one.faces, other.faces)


def alike(one: TexturedMesh, other: TexturedMesh, face: Array, weights: Array) -> Array:
    """At which spots the paints of two meshes of one shape are alike, bool, shape (n,).

    Args:
        one: A mesh.
        other: Another one.
        face: As from spots(), shape (n,).
        weights: Likewise, shape (n, 3).
    """
    first, second = (lab(colours_at(mesh, face, weights)) for mesh in (one, other))
    return ciede2000(first, second) <= _GRAIN


def _shared_sides(spec: ObjectSpec, mesh: TexturedMesh, other: TexturedMesh) -> tuple[Array, Array]:
    """Angles and patches of the sides on which two things are alike; see PaintTwins."""
    face, weights = spots(mesh.vertices, mesh.faces, _SPOTS)
    points = places(mesh.vertices, mesh.faces, face, weights)
    if lies_on_side(spec):
        points = Pose(wxyz=on_side(spec)).apply(points)
    top, same = _from_above(points), alike(mesh, other, face, weights)
    colours = colours_at(mesh, face, weights)
    angles, patches = list[float](), list[tuple[float, float, float]]()
    for angle in np.arange(_DIRECTIONS) * 2 * math.pi / _DIRECTIONS:
        out = points[:, :2] @ np.array([np.cos(angle), np.sin(angle)])
        outer = top & (out >= np.quantile(out[top], 1 - _OUTER))
        if same[outer].mean() >= ALIKE:
            angles.append(float(angle))
            patches.append(shades(colours[outer])[0].lab)
    return np.array(angles), np.array(patches).reshape(-1, 3)


def _from_above(points: Array) -> Array:
    """Which points, shape (n, 3), have none of the others far above them."""
    low, high = points.min(axis=0), points.max(axis=0)
    cells = ((points[:, :2] - low[:2]) / (high - low)[:2].max() * (_CELLS - 1)).astype(int)
    cell = cells[:, 0] * _CELLS + cells[:, 1]
    return topmost(cell, points[:, 2], _CELLS * _CELLS, _SKIN * (high - low)[2])
