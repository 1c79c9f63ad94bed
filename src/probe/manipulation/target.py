"""The thing that a mask marks, completed into a solid. Knows no gripper.

A camera above sees tops only. Where they end over something lower, a wall is supposed to run
straight down to it: this gives the places that a finger can press from the side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.manipulation.terrain import CELL, Terrain, lifted, raster
from probe.types import Array, Frame

_STEP = 0.004
_LEVELS = 16
_BLUR = 2.0
_SURFACE = 0.003
_MARGIN = 12
# A drop to the next cell deeper than this is a wall, else a slope. A wall that the camera sees
# from aside may show its topmost millimetres in that cell, so the one after it is asked too.
_STEEP = 0.005
_SIDES = ((1, 0), (-1, 0), (0, 1), (0, -1))


@dataclass(frozen=True, eq=False)
class Target:
    """A thing as a solid.

    Attributes:
        cells: Which cells of the terrain show it, bool, shape (nx, ny).
        heights: Its own height over each cell, -inf where it isn't, shape (nx, ny).
        walls: Points on its sides, metres, shape (n, 3).
        normals: Outward unit normals of those, shape (n, 3).
        top: Points of what is seen of it, one a cell, shape (m, 3).
        centre: Middle of the visible part's volume, its guessed centre of mass, shape (3,).
    """

    cells: Array
    heights: Array
    walls: Array
    normals: Array
    top: Array
    centre: Array


def target_of(frame: Frame, mask: Array, terrain: Terrain) -> Target:
    """Complete what a mask shows; the terrain is that of the same frame."""
    heights = raster(terrain, lifted(frame, mask))
    cells = heights > terrain.heights - _SURFACE
    heights = np.where(cells, heights, -np.inf)
    rows, columns = np.nonzero(cells)
    if len(rows) == 0:
        empty = np.zeros((0, 3))
        return Target(cells, heights, empty, empty, empty, np.zeros(3))
    top = np.column_stack([terrain.centres(rows, columns), heights[rows, columns]])
    walls, normals = _walls(terrain, heights, rows, columns)
    return Target(cells, heights, walls, normals, top, _centre(top, terrain, cells))


def _centre(top: Array, terrain: Terrain, cells: Array) -> Array:
    """Middle of the columns between what the thing seems to stand on and its top."""
    around = ndimage.binary_dilation(cells, iterations=3) & ~cells
    base = float(np.percentile(terrain.heights[around], 10)) if around.any() else 0.0
    tall = np.maximum(top[:, 2] - base, CELL)
    middle = np.column_stack([top[:, :2], base + tall / 2])
    return np.average(middle, axis=0, weights=tall)


def _walls(terrain: Terrain, heights: Array, rows: Array, columns: Array) -> tuple[Array, Array]:
    """Sides of the solid at several levels: points and outward normals."""
    low = np.array([rows.min(), columns.min()]) - _MARGIN
    window = (
        slice(int(rows.min()), int(rows.max()) + 2 * _MARGIN + 1),
        slice(int(columns.min()), int(columns.max()) + 2 * _MARGIN + 1),
    )
    # What lies beyond the terrain isn't known: no side of the thing is free there.
    own = np.pad(heights, _MARGIN)[window]
    all_heights = np.pad(terrain.heights, _MARGIN, constant_values=np.inf)[window]
    highest = float(own.max())
    step = max(_STEP, highest / _LEVELS)
    found = [
        _contour(own, all_heights, level) for level in np.arange(highest - step / 2, 0.001, -step)
    ]
    if not found:
        return np.zeros((0, 3)), np.zeros((0, 3))
    places = np.concatenate([place for place, _ in found])
    places[:, :2] = terrain.corner + (places[:, :2] + low + 0.5) * CELL
    return places, np.concatenate([normal for _, normal in found])


def _contour(own: Array, heights: Array, level: float) -> tuple[Array, Array]:
    """Where the thing ends at a level with nothing beside it.

    Returns:
        Row, column and height, shape (n, 3), and outward unit normals, shape (n, 3). A normal
        lies in the level's plane but where the surface slopes.
    """
    solid = own > level
    blurred: Array = ndimage.gaussian_filter(solid.astype(float), _BLUR)
    outward = -np.stack([np.gradient(blurred, axis=0), np.gradient(blurred, axis=1)], axis=-1)
    places: list[Array] = []
    normals: list[Array] = []
    for side in _SIDES:
        beside = np.roll(heights, (-side[0], -side[1]), axis=(0, 1))
        rows, columns = np.nonzero(solid & (beside <= level))
        if len(rows) == 0:
            continue
        across: Array = outward[rows, columns] + outward[rows + side[0], columns + side[1]]
        across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
        drop = own[rows, columns] - beside[rows, columns]
        beyond = np.roll(heights, (-2 * side[0], -2 * side[1]), axis=(0, 1))
        fall = own[rows, columns] - beyond[rows, columns]
        steep = (drop > _STEEP) | (fall > 2 * _STEEP)
        rise = np.where(steep, 0.0, CELL / np.maximum(drop, 1e-4))
        normal = np.column_stack([across, rise])
        normals.append(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-9))
        middle = np.column_stack([rows, columns]) + 0.5 * np.array(side)
        places.append(np.column_stack([middle, np.full(len(rows), level)]))
    if not places:
        return np.zeros((0, 3)), np.zeros((0, 3))
    return np.concatenate(places), np.concatenate(normals)
