"""Where something in a colour and depth picture may end: steps, creases, changes of colour."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.assets.colour.names import lab
from probe.perception.depths import tolerance
from probe.types import Array, Frame

GRID_PX = 512
"""Edges are looked for on a grid of about this many rows."""

TABLE = 0.0025
"""Metres above the table from which on a point belongs to a thing."""

AROUND = 0.8
"""Metres from the table's middle, along x and y, beyond which nothing belongs to the table: an
oblique camera also sees the room behind it."""

_DIRECTIONS = ((0, 1), (1, 0), (1, 1), (1, -1))
_BEND_CELLS = 4
_BORDER = 8


@dataclass(frozen=True, eq=False)
class Relief:
    """A frame on a coarser grid, each array of shape (h, w) but for the colours.

    Attributes:
        stride: Pixels of the frame that a cell is wide.
        raised: Whether the cell shows something above the table, bool.
        lab: CIELAB colour, shape (h, w, 3).
        step: Jump of the distance that the slopes on either side don't explain, millimetres.
        valley: Strongest inward bend of the surface in any direction, radians; 0 where none.
        ridge: The same outward.
        contrast: Distance in CIELAB between the two sides, the largest over directions.
    """

    stride: int
    raised: Array
    lab: Array
    step: Array
    valley: Array
    ridge: Array
    contrast: Array


def relief(frame: Frame) -> Relief:
    """Edges of a frame; it needs colours and depth, labels aren't looked at."""
    assert frame.rgb is not None
    stride = max(1, round(frame.depth.shape[0] / GRID_PX))
    depth = _without_holes(frame.depth.astype(float))[::stride, ::stride]
    colours = _colours(frame.rgb, stride)
    near = -1000 * depth
    cell = 1000 * depth * stride / frame.camera.focal_px
    valley, ridge = _bends(near, cell)
    above = raised(frame, depth, stride)
    return Relief(stride, above, colours, _steps(near), valley, ridge, _contrast(colours))


def raised(frame: Frame, depth: Array, stride: int = 1) -> Array:
    """Which pixels, or every so many, show something that stands on the table, bool.

    Args:
        frame: Where it was taken from.
        depth: Planar depth of these pixels, metres, shape (h, w); NaN without a reading.
        stride: Pixels of the frame from one of them to the next.
    """
    rows, columns = np.indices(depth.shape).reshape(2, -1) * stride
    points = frame.camera.lift(np.column_stack([columns, rows]) + 0.5, depth.ravel())
    near = np.abs(points[:, :2]).max(axis=1) < AROUND
    return ((points[:, 2] > tolerance(TABLE, frame.depth_noise)) & near).reshape(depth.shape)


def _without_holes(depth: Array) -> Array:
    """Places without a reading get that of the nearest one that has it."""
    holes = ~(np.isfinite(depth) & (depth > 0))
    if not holes.any() or holes.all():
        return depth
    nearest = ndimage.distance_transform_edt(holes, return_distances=False, return_indices=True)
    return depth[tuple(nearest)]


def _colours(rgb: Array, stride: int) -> Array:
    """Mean colour of each cell, in CIELAB."""
    h, w = -(-rgb.shape[0] // stride), -(-rgb.shape[1] // stride)
    missing = (h * stride - rgb.shape[0], w * stride - rgb.shape[1])
    whole = np.pad(rgb, ((0, missing[0]), (0, missing[1]), (0, 0)), mode="edge")
    cells = whole.reshape(h, stride, w, stride, 3).mean(axis=(1, 3))
    return lab(cells.reshape(-1, 3)).reshape(h, w, 3)


def _steps(near: Array) -> Array:
    """Jumps between the cells on both sides, less what the slope of the smoother side explains."""
    found = np.zeros_like(near)
    for direction in _DIRECTIONS:
        before, after = _towards(near, direction, -1), _towards(near, direction, 1)
        jump = after - before
        slope = before - _towards(near, direction, -3)
        other = _towards(near, direction, 3) - after
        beyond = np.minimum(np.abs(jump - slope), np.abs(jump - other))
        found = np.maximum(found, np.minimum(beyond, np.abs(jump)))
    return found


def _bends(near: Array, cell: Array) -> tuple[Array, Array]:
    """Strongest inward and outward change of the slope's angle, radians."""
    valley, ridge = np.zeros_like(near), np.zeros_like(near)
    for direction in _DIRECTIONS:
        run = _BEND_CELLS * float(np.hypot(*direction)) * cell
        rise = np.arctan2(near - _towards(near, direction, -_BEND_CELLS), run)
        bend = np.arctan2(_towards(near, direction, _BEND_CELLS) - near, run) - rise
        valley, ridge = np.maximum(valley, bend), np.maximum(ridge, -bend)
    return valley, ridge


def _contrast(colours: Array) -> Array:
    smooth: Array = ndimage.gaussian_filter(colours, (1, 1, 0))
    found = np.zeros(colours.shape[:2])
    for direction in _DIRECTIONS:
        across = _towards(smooth, direction, -2) - _towards(smooth, direction, 2)
        found = np.maximum(found, np.linalg.norm(across, axis=2))
    return found


def _towards(values: Array, direction: tuple[int, int], cells: int) -> Array:
    """What lies so many cells on in a direction (down, across); at the border its own end."""
    down, across = direction[0] * cells, direction[1] * cells
    widths = ((_BORDER, _BORDER), (_BORDER, _BORDER)) + ((0, 0),) * (values.ndim - 2)
    padded = np.pad(values, widths, mode="edge")
    h, w = values.shape[:2]
    top, left = _BORDER + down, _BORDER + across
    return padded[top : top + h, left : left + w]
