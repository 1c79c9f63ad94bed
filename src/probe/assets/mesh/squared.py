"""Turn a lying object about the vertical so that its box is the smallest. Knows no formats."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.collision.hulls import hull_of
from probe.types import Array

GAIN = 0.02
"""Share of its area that the box has to lose, else the object stays as it is: a round one has no
best turn, and noise would choose one."""


def squaring_turn(vertices: Array) -> Array:
    """The smallest turn about z, shape (3, 3), that gives the smallest upright box.

    A thing that lies askew in its file measures too long and too wide along x and y: a hammer at
    30 degrees by a fifth. The smallest rectangle around points has a side along one of their
    hull's (Freeman and Shapira, CACM 18(7), 1975).

    Args:
        vertices: In the resting pose, shape (n, 3).
    """
    hull = hull_of(vertices)
    if hull is None:
        return np.eye(3)
    flat = vertices[hull.vertices][:, :2]
    sides = flat[_outline(flat)]
    along = np.roll(sides, -1, axis=0) - sides
    angles = np.unique(np.round(np.arctan2(along[:, 1], along[:, 0]) % (math.pi / 2), 9))
    areas = np.array([_area(flat, angle) for angle in angles])
    if areas.min() > (1 - GAIN) * _area(flat, 0.0):
        return np.eye(3)
    angle = float(angles[int(areas.argmin())])
    return _turn(angle if angle <= math.pi / 4 else angle - math.pi / 2)


def _outline(flat: Array) -> Array:
    """Indices of the points on the convex outline, in order."""
    return ConvexHull(flat).vertices


def _area(flat: Array, angle: float) -> float:
    """Area of the rectangle around points whose side is at an angle to x."""
    width, depth = np.ptp(flat @ _turn(angle)[:2, :2].T, axis=0)
    return float(width * depth)


def _turn(angle: float) -> Array:
    """The turn about z that brings what is at an angle to x onto x."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
