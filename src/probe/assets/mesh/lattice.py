"""Points spread evenly over a surface, without chance. Knows no file format."""

from __future__ import annotations

import numpy as np

from probe.assets.mesh.mesh import TexturedMesh
from probe.types import Array

_STEPS = np.array([0.7548776662466927, 0.5698402909980532])
"""First and second power of the plastic number's inverse: multiples of it fill a square evenly
(M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018)."""


def spots(vertices: Array, faces: Array, count: int) -> tuple[Array, Array]:
    """Spots spread by area, in the order of the faces.

    Args:
        vertices: Shape (n, 3).
        faces: Shape (m, 3), some with an area.
        count: How many.

    Returns:
        The face of each, shape (count,), and the weights of its three corners, shape (count, 3).
    """
    a, b, c = np.moveaxis(np.asarray(vertices, np.float64)[faces], 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    share = np.cumsum(areas) / areas.sum()
    number = np.arange(count)
    face = np.minimum(np.searchsorted(share, (number + 0.5) / count), len(faces) - 1)
    within = np.modf((number + 1)[:, None] * _STEPS)[0]
    within = np.where(within.sum(axis=1, keepdims=True) > 1, 1 - within, within)
    return face, np.column_stack([1 - within.sum(axis=1), within])


def places(vertices: Array, faces: Array, face: Array, weights: Array) -> Array:
    """Where spots are, shape (count, 3)."""
    return np.einsum("ij,ijk->ik", weights, np.asarray(vertices, np.float64)[faces[face]])


def topmost(cell: Array, heights: Array, count: int, skin: float) -> Array:
    """Which points have no other far above them in the same cell, bool, shape (n,).

    Args:
        cell: The number of each point's, shape (n,).
        heights: Of the points, shape (n,).
        count: How many cells there are.
        skin: How far below a cell's highest point others count as high, too.
    """
    top = np.full(count, -np.inf)
    np.maximum.at(top, cell, heights)
    return heights > top[cell] - skin


def colours_at(mesh: TexturedMesh, face: Array, weights: Array) -> Array:
    """The texture's colour at spots, sRGB uint8, shape (count, 3); it repeats beyond its edges."""
    uv = np.einsum("ij,ijk->ik", weights, mesh.uvs[mesh.faces[face]].astype(np.float64))
    height, width = mesh.surface.texture.shape[:2]
    column = np.floor((uv[:, 0] % 1.0) * width).astype(int).clip(0, width - 1)
    row = np.floor((uv[:, 1] % 1.0) * height).astype(int).clip(0, height - 1)
    return mesh.surface.texture[row, column]


def lattice_points(vertices: Array, faces: Array, spacing: float) -> Array:
    """Points on every face, at most `spacing` apart along and across it, shape (n, 3).

    Args:
        vertices: Shape (k, 3), metres.
        faces: Shape (m, 3).
        spacing: Metres.
    """
    corners = np.asarray(vertices, dtype=np.float64)[faces]
    lengths = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    # Rows run from the corner opposite the shortest edge towards it: needles stay cheap.
    order = (lengths.argmin(axis=1)[:, None] + np.array([2, 0, 1])) % 3
    apex, a, b = np.moveaxis(np.take_along_axis(corners, order[..., None], axis=1), 1, 0)
    rows = np.ceil(lengths.max(axis=1) / spacing).astype(int).clip(1)
    columns = np.ceil(lengths.min(axis=1) / spacing).astype(int).clip(1)
    points: list[Array] = []
    for many, wide in np.unique(np.column_stack([rows, columns]), axis=0):
        here = (rows == many) & (columns == wide)
        s = np.linspace(0, 1, many + 1)[:, None, None]
        t = np.linspace(0, 1, wide + 1)[:, None]
        edge = a[here, None, None] * (1 - t) + b[here, None, None] * t
        points.append((apex[here, None, None] * (1 - s) + edge * s).reshape(-1, 3))
    return np.concatenate(points)
