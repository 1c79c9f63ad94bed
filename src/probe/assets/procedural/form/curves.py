"""Plane and space curves that profiles and paths are made of. Knows no surfaces."""

from __future__ import annotations

import math
from typing import Any, cast

import numpy as np
from scipy.interpolate import CubicSpline

from probe.types import Array

ARC_STEP = math.radians(24)  # turn between neighbouring points of a fillet


def arc_length(points: Array) -> Array:
    """Length along a polyline, shape (n, d), at each of its points, shape (n,)."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def filleted(corners: Array) -> Array:
    """Polyline through plane corners with rounded bends.

    Args:
        corners: Rows (x, y, fillet radius), metres, shape (k, 3). A radius of zero keeps the
            corner; a radius too large for its neighbours is cut down to what fits.

    Returns:
        Points, shape (n, 2).
    """
    xy, radii = corners[:, :2], corners[:, 2]
    bends = [_bend(xy[i - 1 : i + 2], float(radii[i])) for i in range(1, len(xy) - 1)]
    return distinct(np.vstack([xy[:1], *bends, xy[-1:]]))


def _bend(three: Array, radius: float) -> Array:
    """Arc that replaces the middle one of three points, shape (n, 2)."""
    before, corner, after = three
    back, ahead = before - corner, after - corner
    room = min(float(np.linalg.norm(back)), float(np.linalg.norm(ahead))) * 0.499
    back, ahead = back / np.linalg.norm(back), ahead / np.linalg.norm(ahead)
    turn = math.pi - math.acos(float(np.clip(back @ ahead, -1, 1)))
    if radius <= 0 or turn < 0.02:
        return corner[None]
    reach = min(radius * math.tan(turn / 2), room)
    radius = reach / math.tan(turn / 2)
    middle = (back + ahead) / np.linalg.norm(back + ahead)
    centre = corner + middle * math.hypot(radius, reach)
    start, end = corner + back * reach - centre, corner + ahead * reach - centre
    t = np.linspace(0, 1, max(2, math.ceil(turn / ARC_STEP)) + 1)[:, None]
    # Spherical interpolation between the two radii of the arc.
    weights = np.sin((1 - t) * turn), np.sin(t * turn)
    return centre + (weights[0] * start + weights[1] * end) / math.sin(turn)


def smoothed(points: Array, step: float) -> Array:
    """Cubic spline through points, shape (k, d), sampled about every ``step`` metres."""
    return _sampled(CubicSpline(arc_length(points), points), points, step)


def smoothed_between_poles(points: Array, step: float) -> Array:
    """Like `smoothed` for a profile (r, z) that leaves and meets its axis at right angles."""
    ends = ((1, np.array([1.0, 0.0])), (1, np.array([-1.0, 0.0])))
    return _sampled(CubicSpline(arc_length(points), points, bc_type=cast(Any, ends)), points, step)


def _sampled(spline: CubicSpline, points: Array, step: float) -> Array:
    length = float(arc_length(points)[-1])
    count = max(8, math.ceil(length / step)) + 1
    return np.asarray(spline(np.linspace(0, length, count)))


def resampled(points: Array, step: float) -> Array:
    """The same polyline with extra points so that no segment is longer than ``step``."""
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    pieces: list[Array] = [
        np.linspace(points[i], points[i + 1], max(1, math.ceil(length / step)), endpoint=False)
        for i, length in enumerate(lengths)
    ]
    return np.vstack([*pieces, points[-1:]])


def at_length(points: Array, where: Array) -> Array:
    """Points of a polyline at given lengths along it, shape (k, d)."""
    t = arc_length(points)
    columns = [np.interp(where, t, points[:, axis]) for axis in range(points.shape[1])]
    return np.column_stack(columns)


def distinct(points: Array) -> Array:
    """The polyline without repeated neighbours (closer than a micrometre)."""
    keep = np.concatenate([[True], np.linalg.norm(np.diff(points, axis=0), axis=1) > 1e-6])
    return points[keep]
