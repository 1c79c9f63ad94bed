"""Points spread evenly over a surface, without chance. Knows no file format."""

from __future__ import annotations

import numpy as np

from probe.types import Array


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
