"""Where a mask is and what it is shaped like. Knows no objects."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import distance_transform_edt
from scipy.spatial import ConvexHull

from probe.types import Array

_LONG = 2.2
_SQUARISH = 1.35
_BOXY_FILL = 0.88
_ROUND_FILL = 0.72
_FLAT = 0.008


def box_of(mask: Array) -> tuple[int, int, int, int]:
    """First and last column and row of a mask that isn't empty: left, top, right, bottom."""
    columns, rows = np.flatnonzero(mask.any(axis=0)), np.flatnonzero(mask.any(axis=1))
    return int(columns[0]), int(rows[0]), int(columns[-1]), int(rows[-1])


def window_of(mask: Array, margin: int) -> tuple[slice, slice]:
    """Rows and columns of a mask that isn't empty, and so many pixels around them."""
    left, top, right, bottom = box_of(mask)
    rows = slice(max(top - margin, 0), bottom + margin + 1)
    return rows, slice(max(left - margin, 0), right + margin + 1)


def interior_point(mask: Array) -> tuple[int, int]:
    """(u, v) of the pixel deepest inside a mask; see deepest_inside."""
    return deepest_inside(mask)[0]


def deepest_inside(mask: Array) -> tuple[tuple[int, int], float]:
    """(u, v) of the pixel deepest inside a mask that isn't empty, and its distance from the edge.

    The first in reading order if several are. The picture's border counts as an edge, so the
    point keeps away from it.
    """
    left, top, right, bottom = box_of(mask)
    patch = np.pad(mask[top : bottom + 1, left : right + 1], 1)
    depth: Array = np.asarray(distance_transform_edt(patch))
    v, u = divmod(int(depth.argmax()), patch.shape[1])
    return (u - 1 + left, v - 1 + top), float(depth[v, u])


def shape_word(mask: Array, heights: Array) -> str:
    """One or two words for the outline of the visible part.

    Args:
        mask: Visible pixels, bool, shape (h, w).
        heights: Heights of these pixels above the table in metres, shape (n,), to tell flat things.
    """
    elongation, fill = _proportions(mask)
    if elongation >= _LONG:
        return "long"
    if fill >= _BOXY_FILL:
        low, high = np.percentile(heights, (5, 95))
        return "flat boxy" if high - low < _FLAT else "boxy"
    if elongation < _SQUARISH and fill >= _ROUND_FILL:
        return "round"
    return "irregular"


def _proportions(mask: Array) -> tuple[float, float]:
    """Elongation of the smallest box around the visible part, and the share of it that is filled.

    One side of the smallest box lies along an edge of the convex hull (Freeman and Shapira,
    "Determining the minimum-area encasing rectangle for an arbitrary closed curve", CACM 18(7),
    1975).
    """
    rows, columns = np.nonzero(mask)
    corners = _corners(rows, columns)
    edges = np.diff(corners, axis=0, append=corners[:1])
    angles = np.unique(np.arctan2(edges[:, 1], edges[:, 0]) % (np.pi / 2))
    across = np.column_stack([np.cos(angles), np.sin(angles)])
    down = np.column_stack([-np.sin(angles), np.cos(angles)])
    widths, heights = (np.ptp(corners @ way.T, axis=0) for way in (across, down))
    best = int((widths * heights).argmin())
    long, short = sorted((float(widths[best]), float(heights[best])), reverse=True)
    return long / short, len(rows) / (long * short)


def _corners(rows: Array, columns: Array) -> Array:
    """Corners of the convex hull of pixels, squares of side 1, in order, shape (n, 2)."""
    pixels = np.column_stack([columns, rows])
    corners = np.vstack([pixels + np.array(off) for off in ((0, 0), (0, 1), (1, 0), (1, 1))])
    return corners[ConvexHull(corners).vertices].astype(float)
