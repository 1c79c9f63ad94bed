"""What a depth picture says of the table: heights on a grid. Knows neither arm nor gripper.

Seen from above every thing hides what is beneath it, so each cell counts as filled from the table
up to the highest point seen over it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from probe.perception.depths import tolerance
from probe.scene.setup import Basket, Setup
from probe.types import Array, Camera, Frame

CELL = 0.002
"""Edge of a cell in metres; a pixel of the fixed camera covers about a quarter of that."""

_DENSITY = 0.6
_MARGIN = 0.08
_RIM = 0.012
"""Thickness that the basket's walls are given, metres."""

_SHADOW_SIZES = (31, 91)
"""Windows, in cells, in which a cell that no ray reached looks for the lowest seen one."""


@dataclass(frozen=True, eq=False)
class Terrain:
    """Heights over the table.

    Attributes:
        heights: Highest point over each cell in metres, shape (nx, ny); its border is 0.
        corner: x and y of the grid's lowest corner, shape (2,).
    """

    heights: Array
    corner: Array

    def cells(self, xy: Array) -> tuple[Array, Array]:
        """Indices of the cells of points, shape (..., 2); beyond the grid those of its border."""
        # Towards zero rather than down: what lies beyond the grid falls on its border anyway.
        index = ((xy - self.corner) * (1 / CELL)).astype(np.int32)
        nx, ny = self.heights.shape
        rows = np.minimum(np.maximum(index[..., 0], 0), nx - 1)
        return rows, np.minimum(np.maximum(index[..., 1], 0), ny - 1)

    def below(self, points: Array) -> Array:
        """Height of the terrain below points, shape (..., 3), in metres, shape (...)."""
        return self.heights[self.cells(points[..., :2])]

    def centres(self, rows: Array, columns: Array) -> Array:
        """x and y of cells' middles, shape (n, 2)."""
        return self.corner + (np.column_stack([rows, columns]) + 0.5) * CELL

    def widened(self, metres: float) -> Terrain:
        """The same with everything grown sideways by a margin."""
        size = 2 * round(metres / CELL) + 1
        return replace(self, heights=ndimage.maximum_filter(self.heights, size))

    def without(self, cells: Array) -> Terrain:
        """The same with some cells, bool of the grid's shape, empty down to the table."""
        return replace(self, heights=np.where(cells, 0.0, self.heights))


def survey(frame: Frame, setup: Setup, basket: Frame | None = None) -> Terrain:
    """Heights of all that a frame shows, with the basket's walls beside it.

    Cells in the shadow of something tall are as low as the lowest ones near them. What the
    camera's noise alone may raise above the table is the table.

    Args:
        frame: From a camera that looks down on the table, straight or obliquely.
        setup: The table's.
        basket: From the camera above the basket; None where what lies in it doesn't matter.
    """
    middle = np.array(setup.basket.position[:2])
    half = np.array(setup.basket.size[:2]) / 2 + _RIM
    reach = np.full(2, setup.view_size / 2)
    low = np.minimum(-reach, middle - half) - _MARGIN
    high = np.maximum(reach, middle + half) + _MARGIN
    shape = np.ceil((high - low) / CELL).astype(int)
    empty = Terrain(np.full(tuple(shape.tolist()), -np.inf), low)
    everything = np.ones_like(frame.depth, bool)
    seen = raster(empty, lifted(frame, everything, step=_step(frame.camera)))
    heights = np.maximum(_shadows_filled(seen), 0.0)
    heights[heights < tolerance(0.0, frame.depth_noise)] = 0.0
    terrain = replace(empty, heights=heights)
    if basket is not None:
        inside = raster(terrain, lifted(basket, np.ones_like(basket.depth, bool)))
        np.maximum(heights, _within(terrain, setup.basket, inside), out=heights)
    stamp_basket(terrain, setup.basket)
    heights[[0, -1], :] = 0.0
    heights[:, [0, -1]] = 0.0
    return terrain


def _step(camera: Camera) -> int:
    """Of how many pixels one will do; seen obliquely, the table shows in few enough."""
    if not camera.looks_down:
        return 1
    pixel = camera.world_from_camera.position[2] / camera.focal_px
    return max(1, int(_DENSITY * CELL / pixel))


def lifted(frame: Frame, mask: Array, step: int = 1) -> Array:
    """World points, shape (n, 3), of a mask's pixels, or of every so many rows and columns."""
    rows, columns = np.nonzero(mask[::step, ::step])
    uv = np.column_stack([columns, rows]) * step + 0.5
    return frame.camera.lift(uv, frame.depth[rows * step, columns * step])


def raster(terrain: Terrain, points: Array) -> Array:
    """Highest of the points, shape (n, 3), over each cell of a terrain's grid; -inf over none."""
    heights = np.full(terrain.heights.shape, -np.inf)
    np.maximum.at(heights, terrain.cells(points[:, :2]), points[:, 2])
    return heights


def _shadows_filled(seen: Array) -> Array:
    """Unseen cells become as low as the lowest seen cell near them; the far ones 0."""
    known = np.isfinite(seen)
    filled = np.where(known, seen, 0.0)
    share = ndimage.uniform_filter(known.astype(float), 3)
    # A lone gap between seen cells is no shadow.
    gap = ~known & (share > 0.85)
    filled[gap] = ndimage.uniform_filter(filled, 3)[gap] / share[gap]
    known |= gap
    for size in _SHADOW_SIZES:
        lowest = ndimage.minimum_filter(np.where(known, filled, np.inf), size)
        found = ~known & np.isfinite(lowest)
        filled[found] = lowest[found]
        known |= found
    return filled


def _within(terrain: Terrain, basket: Basket, heights: Array) -> Array:
    """Heights, shape (nx, ny), over the basket's floor; 0 elsewhere."""
    x, y = _from_middle(terrain, basket)
    inner = np.array(basket.size[:2]) / 2
    return np.where((x <= inner[0]) & (y <= inner[1]), heights, 0.0)


def _from_middle(terrain: Terrain, basket: Basket) -> tuple[Array, Array]:
    """How far cells lie from the basket's middle, along x, shape (nx, 1), and y, (1, ny)."""
    nx, ny = terrain.heights.shape
    x = np.abs(terrain.corner[0] + (np.arange(nx) + 0.5) * CELL - basket.position[0])[:, None]
    y = np.abs(terrain.corner[1] + (np.arange(ny) + 0.5) * CELL - basket.position[1])[None, :]
    return x, y


def stamp_basket(terrain: Terrain, basket: Basket) -> None:
    """Raise, in place, the cells of a basket's walls."""
    inner = np.array(basket.size[:2]) / 2
    x, y = _from_middle(terrain, basket)
    outside = (x > inner[0]) | (y > inner[1])
    wall = outside & (x < inner[0] + _RIM) & (y < inner[1] + _RIM)
    terrain.heights[wall] = basket.position[2] + basket.size[2]
