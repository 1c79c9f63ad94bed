"""Convex hulls of point sets that may be flat, and their reduction to few corners."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from probe.types import Array

MAX_CORNERS = 63
THINNEST = 2e-4


def hull_of(points: Array) -> ConvexHull | None:
    """Hull of points, shape (n, 3); None where they lie in a plane."""
    if len(points) < 4:
        return None
    try:
        return ConvexHull(points)
    except QhullError:
        return None


def hull_volume(points: Array) -> float:
    """Volume of the hull in cubic metres; 0 where the points lie in a plane."""
    hull = hull_of(points)
    return 0.0 if hull is None else float(hull.volume)


def corners(points: Array, limit: int = MAX_CORNERS) -> Array | None:
    """Corners of a hull, at most `limit` of them, shape (k, 3).

    Corners beyond the limit are left out so that what is cut off stays thin: starting from the
    extremes, the corner farthest outside the hull so far joins it, one facet after another.

    Returns:
        None for slivers, thinner than 0.2 mm or flat.
    """
    hull = hull_of(points)
    if hull is None or thickness(points[hull.vertices]) < THINNEST:
        return None
    candidates = points[np.sort(hull.vertices)]
    if len(candidates) <= limit:
        return candidates
    chosen = _extremes(candidates)
    while len(chosen) < limit:
        partial = hull_of(candidates[chosen])
        if partial is None:
            return None
        height = candidates @ partial.equations[:, :3].T + partial.equations[:, 3]
        order = np.argsort(-height.max(axis=0), kind="stable")
        farthest = height.argmax(axis=0)[order[: max(1, (limit - len(chosen)) // 4)]]
        chosen = np.union1d(chosen, farthest)[:limit] if len(farthest) else chosen
    return candidates[chosen]


def thickness(points: Array) -> float:
    """Extent along the direction in which points, shape (n, 3), spread least, in metres."""
    return float(np.ptp(points @ principal_axes(points)[0]))


def principal_axes(points: Array) -> Array:
    """Unit directions, one a row, along which points, shape (n, 3), spread least to most."""
    centred = points - points.mean(axis=0)
    return np.linalg.eigh(centred.T @ centred)[1].T


def span(points: Array, at: Array) -> tuple[Array, Array]:
    """Lowest and highest z of a hull over given places.

    Args:
        points: Corners, shape (n, 3).
        at: (x, y) of each place, shape (k, 2).

    Returns:
        Bottom and top, shape (k,) each; +inf and -inf where the vertical misses the hull.
    """
    hull = hull_of(points)
    bottom, top = np.full(len(at), -np.inf), np.full(len(at), np.inf)
    if hull is None:
        return -bottom, -top
    outside = np.zeros(len(at), dtype=bool)
    for nx, ny, nz, offset in hull.equations:
        rest = at @ np.array([nx, ny]) + offset
        if nz > 1e-9:
            top = np.minimum(top, -rest / nz)
        elif nz < -1e-9:
            bottom = np.maximum(bottom, -rest / nz)
        else:
            outside |= rest > 0
    outside |= bottom > top
    return np.where(outside, np.inf, bottom), np.where(outside, -np.inf, top)


def _extremes(points: Array) -> Array:
    """Indices of the points farthest along the 26 directions of a cube's neighbours."""
    steps = np.indices((3, 3, 3)).reshape(3, -1).T - 1
    steps = steps[np.any(steps != 0, axis=1)]
    return np.unique((points @ steps.T).argmax(axis=0))
