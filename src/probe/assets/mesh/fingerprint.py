"""Is this still the same object? By figures that hold on any machine, not by its bytes.

The last bits of sines and powers differ between types of CPU, and so do the bytes of an object
that is made from a formula: a hash of them would refuse a suite that was frozen on another
machine. What differs by less than the tolerances below can't be seen, felt or measured here.
"""

from __future__ import annotations

import numpy as np

from probe.assets.mesh.mesh import Body
from probe.types import Array

Fingerprint = tuple[float, ...]

_GRID = 4
_COUNTS = 3
_COLOURS = 3 * _GRID * _GRID
_LENGTH_TOLERANCE = 2e-5
_COLOUR_TOLERANCE = 0.5


def fingerprint(body: Body) -> Fingerprint:
    """Numbers that describe a body.

    Returns:
        How many vertices, faces and pieces; mean colours (0 to 255) of the texture's parts, four
        by four; then, in metres but for the last four: how the vertices and the pieces' bounds are
        spread, the mean texture coordinates, roughness and metal.
    """
    mesh = body.mesh
    counts = [len(mesh.vertices), len(mesh.faces), len(body.pieces)]
    colours = _colours(mesh.surface.texture)
    bounds = np.array(
        [np.concatenate([p.vertices.min(axis=0), p.vertices.max(axis=0)]) for p in body.pieces]
    )
    surface = [mesh.surface.roughness, mesh.surface.metallic]
    shape = [_spread(mesh.vertices.astype(float)), _spread(bounds), mesh.uvs.mean(axis=0), surface]
    numbers = np.concatenate([counts, colours.ravel().round(2), *shape])
    return tuple(round(float(number), 7) for number in numbers)


def same(one: Fingerprint, other: Fingerprint) -> bool:
    """Whether two fingerprints are of the same object."""
    if len(one) != len(other):
        return False
    a, b = np.array(one), np.array(other)
    apart = np.abs(a - b)
    colours = slice(_COUNTS, _COUNTS + _COLOURS)
    alike = (a[:_COUNTS] == b[:_COUNTS]).all() and (apart[colours] <= _COLOUR_TOLERANCE).all()
    return bool(alike and (apart[_COUNTS + _COLOURS :] <= _LENGTH_TOLERANCE).all())


def _colours(texture: Array) -> Array:
    """Mean colours of a texture's parts, shape (4, 4, 3); 0 where it has fewer rows or columns."""
    colours = np.zeros((_GRID, _GRID, 3))
    for i, row in enumerate(np.array_split(texture, min(_GRID, len(texture)), axis=0)):
        # Whole rows are added up first: many times as fast as cell by cell.
        sums = row.reshape(len(row), -1).sum(axis=0, dtype=np.int64).reshape(-1, 3)
        for j, cell in enumerate(np.array_split(sums, min(_GRID, len(sums)), axis=0)):
            colours[i, j] = cell.sum(axis=0) / (len(row) * len(cell))
    return colours


def _spread(points: Array) -> Array:
    """Mean, deviation, lowest and highest of each column."""
    return np.concatenate(
        [points.mean(axis=0), points.std(axis=0), points.min(axis=0), points.max(axis=0)]
    )
