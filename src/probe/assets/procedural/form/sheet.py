"""A surface as a grid of points with texture coordinates: what every solid is made of."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from probe.types import Array, Pose

# Spreads whole numbers (x, y, z, group) over 64 bits, so that equal rows can be found fast.
HASH = np.array([73_856_093_000_003, 19_349_663_000_017, 83_492_791_000_029, 1_000_000_007])


@dataclass(frozen=True, eq=False)
class Sheet:
    """A rectangular grid of points bent in space, with its own picture.

    Along a row (first to last column) crossed with down the rows (first to last) points out.

    Attributes:
        points: Metres, shape (rows, columns, 3).
        normals: Unit vectors, shape (rows, columns, 3).
        uvs: Coordinates in the sheet's own picture, (0, 0) at its top left, shape (rows,
            columns, 2).
        extent: Width and height of the picture on the surface, metres.
        plane: For a picture laid on flat (a lid, the side of a box): its top left corner, and
            the way along its width and down its height, metres, shape (3, 3). None where all
            points of a row share v and all of a column share u.
    """

    points: Array
    normals: Array
    uvs: Array
    extent: tuple[float, float]
    plane: Array | None = None

    def moved(self, pose: Pose) -> Sheet:
        """The sheet, rigidly moved."""
        plane = self.plane
        if plane is not None:
            plane = plane @ pose.rotation.T + np.array([pose.position, (0, 0, 0), (0, 0, 0)])
        return replace(
            self,
            points=self.points @ pose.rotation.T + np.asarray(pose.position),
            normals=self.normals @ pose.rotation.T,
            plane=plane,
        )

    def scaled(self, factor: float) -> Sheet:
        """The sheet, enlarged about the origin."""
        width, height = self.extent
        plane = None if self.plane is None else self.plane * factor
        extent = (width * factor, height * factor)
        return replace(self, points=self.points * factor, extent=extent, plane=plane)

    def stretched(self, factors: Array) -> Sheet:
        """The sheet, enlarged by a factor along each of x, y, z, shape (3,)."""
        points, normals = self.points * factors, self.normals / factors
        before, after = _spread(self.points), _spread(points)
        width, height = np.array(self.extent) * after / np.where(before > 0, before, 1)
        return replace(
            self,
            points=points,
            normals=normals / np.linalg.norm(normals, axis=-1, keepdims=True),
            plane=None if self.plane is None else self.plane * factors,
            extent=(float(width), float(height)),
        )

    def map(self, width_px: int, height_px: int) -> Array:
        """Where each pixel of the sheet's picture lies, float32, shape (height, width, 3)."""
        u = (np.arange(width_px) + 0.5) / width_px
        v = (np.arange(height_px) + 0.5) / height_px
        if self.plane is not None:
            corner, right, down = self.plane
            places = corner + u[None, :, None] * right + v[:, None, None] * down
            return places.astype(np.float32)
        places = _interpolated(self.points, self.uvs[:, 0, 1], v)
        places = _interpolated(places.swapaxes(0, 1), self.uvs[0, :, 0], u)
        return places.swapaxes(0, 1).astype(np.float32)

    @property
    def faces(self) -> Array:
        """Triangles as indices into the flattened grid, without degenerate ones, shape (m, 3)."""
        return grid_faces(self.points)


def _spread(points: Array) -> Array:
    """Length of a grid's longest row and of its mean column, shape (2,)."""
    across = np.linalg.norm(np.diff(points, axis=1), axis=-1).sum(axis=1).max()
    down = np.linalg.norm(np.diff(points, axis=0), axis=-1).sum(axis=0).mean()
    return np.array([across, down])


def grid_faces(points: Array) -> Array:
    """Two triangles for each cell of a grid, shape (rows, columns, 3); empty ones left out."""
    rows, columns = points.shape[:2]
    index = np.arange(int(rows * columns), dtype=np.int64).reshape((rows, columns))
    a, b = index[:-1, :-1].ravel(), index[:-1, 1:].ravel()
    c, d = index[1:, 1:].ravel(), index[1:, :-1].ravel()
    faces = np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)
    corners = points.reshape(-1, 3)[faces]
    areas = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    return faces[areas > 1e-12]


def grid_normals(points: Array, groups: Array | None = None) -> Array:
    """Area-weighted vertex normals of a grid, shape (rows, columns, 3).

    Args:
        points: Shape (rows, columns, 3). Points in one place (a seam, a pole) share a normal.
        groups: Smoothing group of each row, shape (rows,): rows of different groups share
            nothing, which makes a crease.
    """
    rows, columns = points.shape[:2]
    flat = points.reshape(-1, 3)
    group = np.zeros(rows) if groups is None else groups
    keys = np.column_stack([np.round(flat * 1e7), np.repeat(group, columns)]).astype(np.int64)
    place = np.unique(keys @ HASH, return_inverse=True)[1].ravel()
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    cells = np.cross(c - a, d - b).reshape(-1, 3)  # twice the area vector of each cell
    at = place.reshape(rows, columns)
    sums = np.zeros((int(place.max()) + 1, 3))
    for corner in (at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]):
        np.add.at(sums, corner.ravel(), cells)
    lengths = np.linalg.norm(sums, axis=1, keepdims=True)
    unit = np.where(lengths > 0, sums / np.where(lengths > 0, lengths, 1), [0.0, 0.0, 1.0])
    return unit[place].reshape(rows, columns, 3)


def _interpolated(values: Array, at: Array, where: Array) -> Array:
    """Rows between rows, linearly: values (n, ...) given at monotonic ``at`` (n,)."""
    if at[0] > at[-1]:
        values, at = values[::-1], at[::-1]
    after = np.clip(np.searchsorted(at, where), 1, len(at) - 1)
    gap = np.maximum(at[after] - at[after - 1], 1e-12)
    share = np.clip((where - at[after - 1]) / gap, 0, 1)[:, None, None]
    return values[after - 1] * (1 - share) + values[after] * share
