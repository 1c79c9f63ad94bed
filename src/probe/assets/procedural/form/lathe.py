"""Surfaces of revolution and their cousins around a rounded rectangle. Knows no colour."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from probe.assets.procedural.form.curves import arc_length
from probe.assets.procedural.form.sheet import Sheet, grid_normals
from probe.types import Array

CREASE = math.radians(40)  # a sharper bend of the profile is an edge one can see


@dataclass(frozen=True)
class Base:
    """The rectangle around which a profile is led: half sides (0, 0) make a plain revolution.

    Attributes:
        half: Half sides of the inner rectangle, metres.
        corner: Radius of the profile at which the rectangle has its full size; nearer to the
            axis it shrinks with the radius, so that floors close in the middle.
        segments: Steps around a full turn.
    """

    half: tuple[float, float] = (0.0, 0.0)
    corner: float = 1.0
    segments: int = 64

    @property
    def angles(self) -> Array:
        """Directions of the profile, once around; doubled where a straight side begins."""
        turn = np.linspace(0, 2 * math.pi, self.segments + 1)
        if self.half == (0.0, 0.0):
            return turn
        quarter = np.linspace(0, math.pi / 2, self.segments // 4 + 1)
        corners = np.concatenate([quarter + k * math.pi / 2 for k in range(4)])
        return np.append(corners, 2 * math.pi)

    def ring(self, angles: Array, side: Array, radius: float, z: float) -> Array:
        """Points at a radius and height, shape (n, 3).

        Args:
            angles: Directions, shape (n,).
            side: Quarter (0-3, from +x +y counter-clockwise) that each belongs to, shape (n,).
            radius: Distance from the inner rectangle, metres.
            z: Height, metres.
        """
        share = min(1.0, max(0.0, radius / self.corner))
        signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])[side % 4]
        inner = signs * np.asarray(self.half) * share
        x, y = inner.T + radius * np.array([np.cos(angles), np.sin(angles)])
        return np.column_stack([x, y, np.full(len(x), z)])

    def grid(self, profile: Array) -> Array:
        """The whole surface of a profile (r, z), shape (n, 2), as shape (n, columns, 3)."""
        angles = self.angles
        side = np.minimum(np.arange(len(angles)) // (self.segments // 4 + 1), 4)
        if self.half == (0.0, 0.0):
            side = np.zeros(len(angles), dtype=int)
        return np.stack([self.ring(angles, side, float(r), float(z)) for r, z in profile])


def turn(curves: list[Array], base: Base, planar: list[bool]) -> list[Sheet]:
    """Lead profiles around a base: one sheet for each, smooth where one goes on as the next.

    Args:
        curves: Profiles (r, z) in metres, shape (n, 2), each starting where the last ended;
            the solid is to the left, so an outer wall runs upward.
        base: What they are led around.
        planar: For each, whether its picture is laid on from above rather than wrapped around.
    """
    split = [_with_edges_doubled(curve) for curve in curves]
    profile = np.vstack(split)
    points = base.grid(profile)
    normals = grid_normals(points, _smoothing_groups(profile))
    ends = np.cumsum([len(curve) for curve in split])
    sheets: list[Sheet] = []
    for curve, end, flat in zip(split, ends, planar, strict=True):
        rows = slice(int(end) - len(curve), int(end))
        lay = _from_above if flat else _wrapped
        sheets.append(lay(points[rows], normals[rows]))
    return sheets


def _with_edges_doubled(curve: Array) -> Array:
    """The profile with each point at a sharp bend repeated, so that it can have two normals."""
    sharp = np.concatenate([[False], _bends(curve) > CREASE, [False]])
    return np.repeat(curve, 1 + sharp, axis=0)


def _bends(curve: Array) -> Array:
    """Turning angle at each inner point of a polyline without repeated points, radians."""
    steps = np.diff(curve, axis=0)
    heading = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    return np.abs(np.diff(heading))


def _smoothing_groups(profile: Array) -> Array:
    """Number of each profile row's smooth stretch; repeated points with a sharp bend split."""
    keep = np.concatenate([[True], np.linalg.norm(np.diff(profile, axis=0), axis=1) > 1e-9])
    place = np.cumsum(keep) - 1  # row -> point without repetition
    sharp = np.concatenate([[False], _bends(profile[keep]) > CREASE, [False]])
    second = ~keep & sharp[place]
    return np.cumsum(second)


def _wrapped(points: Array, normals: Array) -> Sheet:
    """A sheet whose picture runs once around and whose top is the end of its profile."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=-1).mean(axis=1)
    down = np.concatenate([[0.0], np.cumsum(steps)])
    widest = int(np.argmax(np.linalg.norm(points[:, 0, :2], axis=1)))
    around = arc_length(points[widest])
    rows, columns = points.shape[:2]
    u = np.broadcast_to(around / around[-1], (rows, columns))
    v = np.broadcast_to(1 - down[:, None] / down[-1], (rows, columns))
    return Sheet(points, normals, np.stack([u, v], axis=-1), (float(around[-1]), float(down[-1])))


def _from_above(points: Array, normals: Array) -> Sheet:
    """A sheet whose picture is laid on along z, x to the right and y up."""
    low, size = points[..., :2].min(axis=(0, 1)), np.ptp(points[..., :2], axis=(0, 1))
    u, v = np.moveaxis((points[..., :2] - low) / size, -1, 0)
    uvs = np.stack([u, 1 - v], axis=-1)
    corner = [low[0], low[1] + size[1], points[..., 2].mean()]
    plane = np.array([corner, [size[0], 0, 0], [0, -size[1], 0]])
    return Sheet(points, normals, uvs, (float(size[0]), float(size[1])), plane)
