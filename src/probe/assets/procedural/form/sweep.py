"""Solids swept along a path: handles, blades, bananas. Knows no colour."""

from __future__ import annotations

import math

import numpy as np

from probe.assets.procedural.form.curves import arc_length
from probe.assets.procedural.form.sheet import Sheet, grid_normals
from probe.types import Array

CAP_STEPS = 5


def section(exponent: float, columns: int) -> Array:
    """Unit superellipse |x|^n + |y|^n = 1, counter-clockwise and closed, shape (columns, 2).

    Two makes an ellipse, larger ones approach a rectangle.
    """
    angle = np.linspace(0, 2 * math.pi, columns)
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([c, s]) / (np.abs(c) ** exponent + np.abs(s) ** exponent)[:, None] ** (
        1 / exponent
    )


def sweep(path: Array, half: Array, outline: Array, up: Array, fillet: float) -> Sheet:
    """Sweep an outline along a path, with rounded flat ends.

    Args:
        path: Centres of the sections, metres, shape (n, 3).
        half: Half width and half height of each section, metres, shape (n, 2).
        outline: Unit section, closed, counter-clockwise seen against the path, shape (k, 2).
        up: Direction of the sections' height where the path lies level, shape (3,); must not
            be along the path.
        fillet: Radius of the rounding at both ends, metres.
    """
    tangents = np.gradient(path, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    path, half, tangents = _capped(path, half, tangents, fillet)
    heights = up - tangents * (tangents @ up)[:, None]
    heights /= np.linalg.norm(heights, axis=1, keepdims=True)
    sides = np.cross(heights, tangents)
    scaled = half[:, None, :] * outline[None]
    points = path[:, None] + scaled[..., :1] * sides[:, None] + scaled[..., 1:] * heights[:, None]
    around = arc_length(points[int(np.argmax(half.sum(axis=1)))])
    along = arc_length(path) + arc_length(half[:, ::-1])  # so that flat ends get some texture
    uvs = np.empty((*points.shape[:2], 2))
    uvs[..., 0], uvs[..., 1] = around / around[-1], 1 - along[:, None] / along[-1]
    return Sheet(points, grid_normals(points), uvs, (float(around[-1]), float(along[-1])))


def _capped(path: Array, half: Array, tangents: Array, fillet: float) -> tuple[Array, Array, Array]:
    """Path, half sizes and tangents with a rounded flat cap added at both ends."""
    angle = np.linspace(0, math.pi / 2, CAP_STEPS + 1)[1:]
    caps: list[tuple[Array, Array, Array]] = []
    for end, way in ((0, -1.0), (-1, 1.0)):
        radius = min(fillet, float(half[end].min()))
        inset = np.append(radius * (1 - np.cos(angle)), np.inf)
        offset = np.append(radius * np.sin(angle), radius) * way
        caps.append(
            (
                path[end] + offset[:, None] * tangents[end],
                np.maximum(half[end] - inset[:, None], 0),
                np.repeat(tangents[end][None], len(offset), axis=0),
            )
        )
    first, last = caps
    return (
        np.vstack([first[0][::-1], path, last[0]]),
        np.vstack([first[1][::-1], half, last[1]]),
        np.vstack([first[2][::-1], tangents, last[2]]),
    )
