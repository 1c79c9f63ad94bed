"""How a thing moved between two looks at the table, tipping included, by depth alone.

Projective point-to-plane ICP (Blais and Levine, "Registering multiview range data to create 3D
computer objects", PAMI 17(8), 1995; Chen and Medioni, "Object modelling by registration of
multiple range images", 1992), from many starts at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.manipulation.terrain import lifted
from probe.types import Array, Camera, Frame

_ROUNDS = 14
_GATES = (0.03, 0.006)
_DAMPING = 1e-4
_EDGE = 0.006
_BLUR_PX = 3.0


@dataclass(frozen=True, eq=False)
class OrientedPoints:
    """Part of what a frame shows, as points with normals.

    Attributes:
        camera: Where it is seen from.
        corner: Row and column of the part's first pixel.
        depth: Planar depth, metres, shape (h, w).
        points: World, metres, shape (h, w, 3).
        normals: Unit vectors, shape (h, w, 3).
        possible: What may belong to the thing that is looked for, bool, shape (h, w).
        smooth: Where a normal means something, bool, shape (h, w).
    """

    camera: Camera
    corner: tuple[int, int]
    depth: Array
    points: Array
    normals: Array
    possible: Array
    smooth: Array

    @staticmethod
    def of(frame: Frame, possible: Array) -> OrientedPoints:
        """The part of a frame around some pixels, bool, shape (h, w), of which there are any."""
        rows, columns = np.nonzero(possible.any(axis=1))[0], np.nonzero(possible.any(axis=0))[0]
        top, left = max(0, rows[0] - 2), max(0, columns[0] - 2)
        part = (slice(top, rows[-1] + 3), slice(left, columns[-1] + 3))
        depth = frame.depth[part]
        window = np.zeros_like(possible)
        window[part] = True
        points = lifted(frame, window).reshape(*depth.shape, 3)
        down, across = np.gradient(_smooth(points, frame.depth_noise), axis=(0, 1))
        normals = np.cross(down, across)
        normals /= np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-12)
        steps = np.abs(np.asarray(np.gradient(depth, axis=(0, 1)))).max(axis=0)
        return OrientedPoints(
            frame.camera,
            (int(top), int(left)),
            depth,
            points,
            normals,
            possible[part],
            steps < _EDGE,
        )

    def under(self, points: Array) -> tuple[Array, Array, Array, Array]:
        """Where points, shape (..., 3), are seen.

        Returns:
            Rows and columns within the part, int; the points' own depth, metres; whether they
            fall on the part. All of shape (...).
        """
        pose = self.camera.world_from_camera
        local = (points - np.array(pose.position)) @ pose.rotation
        depth = local[..., 2]
        centre = np.array([self.camera.width_px, self.camera.height_px]) / 2
        uv = local[..., :2] / depth[..., None] * self.camera.focal_px + centre
        rows = np.floor(uv[..., 1]).astype(int) - self.corner[0]
        columns = np.floor(uv[..., 0]).astype(int) - self.corner[1]
        height, width = self.depth.shape
        inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
        return np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1), depth, inside


@dataclass(frozen=True, eq=False)
class Motions:
    """Rigid motions: x -> rotation (x - pivot) + pivot + shift.

    Attributes:
        rotations: Shape (n, 3, 3).
        shifts: Metres, shape (n, 3).
        pivot: Shape (3,).
    """

    rotations: Array
    shifts: Array
    pivot: Array

    def apply(self, points: Array) -> Array:
        """Moved points, shape (n, k, 3), of points of shape (k, 3)."""
        turned = np.einsum("nij,kj->nki", self.rotations, points - self.pivot)
        return turned + (self.pivot + self.shifts)[:, None]

    def __getitem__(self, chosen: Array) -> Motions:
        return Motions(self.rotations[chosen], self.shifts[chosen], self.pivot)

    def and_also(self, other: Motions) -> Motions:
        """These and others about the same pivot."""
        rotations = np.concatenate([self.rotations, other.rotations])
        return Motions(rotations, np.concatenate([self.shifts, other.shifts]), self.pivot)

    def slid(self, slides: Array) -> Motions:
        """Each motion followed by each of some shifts, shape (k, 3); n k motions."""
        rotations = np.repeat(self.rotations, len(slides), axis=0)
        shifts = (self.shifts[:, None] + slides).reshape(-1, 3)
        return Motions(rotations, shifts, self.pivot)


def _smooth(points: Array, noise: float) -> Array:
    """Points, shape (h, w, 3), as their normals are told: those of a noisy camera, blurred."""
    if noise == 0:
        return points
    blurred: Array = ndimage.gaussian_filter(points, (_BLUR_PX, _BLUR_PX, 0))
    return blurred


def register(surface: OrientedPoints, points: Array, starts: Motions) -> Motions:
    """Let every start slide to where its points lie best on the surface.

    Args:
        surface: Where the thing is looked for.
        points: Of the thing before it moved, world, metres, shape (k, 3).
        starts: First guesses.
    """
    motions = starts
    for gate in np.geomspace(*_GATES, _ROUNDS):
        motions = _step(surface, points, motions, float(gate))
    return motions


def _step(surface: OrientedPoints, points: Array, motions: Motions, gate: float) -> Motions:
    """One Gauss-Newton step on the distances from the tangent planes."""
    placed = motions.apply(points)
    rows, columns, depth, inside = surface.under(placed)
    near = np.abs(surface.depth[rows, columns] - depth) < gate
    usable = surface.possible[rows, columns] & surface.smooth[rows, columns]
    weight = (inside & usable & near).astype(float)
    normals = surface.normals[rows, columns]
    away = ((surface.points[rows, columns] - placed) * normals).sum(axis=2)
    arms = placed - (motions.pivot + motions.shifts)[:, None]
    lever = np.concatenate([np.cross(arms, normals), normals], axis=2)
    weighted = lever * weight[..., None]
    square = np.einsum("nki,nkj->nij", weighted, lever)
    # The scale of a turn is that of the thing's size: metres and radians weigh alike then.
    square += _DAMPING * len(points) * np.diag([0.01] * 3 + [1.0] * 3)
    pull: Array = np.einsum("nki,nk->ni", weighted, away)
    step: Array = np.einsum("nij,nj->ni", np.linalg.inv(square), pull)
    turns = _rotations(step[:, :3])
    return Motions(turns @ motions.rotations, motions.shifts + step[:, 3:], motions.pivot)


def fit(
    surface: OrientedPoints, points: Array, motions: Motions, slack: float
) -> tuple[Array, Array]:
    """How well moved points agree with what is seen.

    Args:
        surface: What is seen.
        points: Of the thing before it moved, shape (k, 3).
        motions: Where it may be now.
        slack: By how much a depth may differ, metres.

    Returns:
        Shares of points that are shown, and of points that would hide what is shown, shape (n,).
    """
    rows, columns, depth, inside = surface.under(motions.apply(points))
    apart = surface.depth[rows, columns] - depth
    shown = inside & surface.possible[rows, columns] & (np.abs(apart) < slack)
    return shown.mean(axis=1), (~inside | (apart >= slack)).mean(axis=1)


def _rotations(turns: Array) -> Array:
    """Rotation matrices, shape (n, 3, 3), of rotation vectors, shape (n, 3); Rodrigues."""
    angles = np.linalg.norm(turns, axis=1)
    x, y, z = (turns / np.maximum(angles, 1e-12)[:, None]).T
    zero = np.zeros_like(x)
    k = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    sin, cos = np.sin(angles)[:, None, None], np.cos(angles)[:, None, None]
    return np.eye(3) + sin * k + (1 - cos) * (k @ k)
