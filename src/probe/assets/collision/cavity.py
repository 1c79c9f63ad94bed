"""Find an object's cavity and measure how much of it a set of convex pieces leaves open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import label

from probe.assets.collision.hulls import hull_of, span
from probe.assets.mesh.lattice import lattice_points
from probe.types import Array

Axis = tuple[int, int, int]

GRID = 64
SHALLOWEST = 0.003
WORTHWHILE = 0.02
GROOVE_SHARE = 0.25
UPRIGHT = ((0, 0, 1), (0, 0, -1))
SIDEWAYS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))


@dataclass(frozen=True)
class Cavity:
    """The largest hollow that is open towards one axis, on a grid of lines along that axis.

    Attributes:
        mouth_from_object: Rotation, shape (3, 3), that turns the opening upwards (+z).
        middle: Middle of the mouth in the turned frame, shape (3,).
        places: (x, y) of each line in the turned frame, shape (k, 2).
        floor: z of the surface on each line, shape (k,).
        roof: z of the convex hull above it, shape (k,).
        volume: Of the hollow below the hull, cubic metres; a quarter of it for mere grooves.
    """

    mouth_from_object: Array
    middle: Array
    places: Array
    floor: Array
    roof: Array
    volume: float

    def kept(self, pieces: Sequence[Array]) -> float:
        """Share of the hollow's volume, 0 to 1, that pieces (corners, (n, 3) each) leave open."""
        floor = self.floor
        for corners in pieces:
            floor = np.maximum(floor, span(corners @ self.mouth_from_object.T, self.places)[1])
        open_height = np.clip(self.roof - floor, 0, None)
        return float(open_height.sum() / (self.roof - self.floor).sum())


def find_cavity(vertices: Array, faces: Array) -> Cavity | None:
    """The cavity of a mesh; openings sideways count only if there is none up or down.

    Args:
        vertices: Shape (n, 3), metres.
        faces: Shape (m, 3); need not be watertight.

    Returns:
        None where no hollow is deeper than 3 mm and larger than 2 % of the hull.
    """
    step = float(np.ptp(vertices, axis=0).max()) / GRID
    points = lattice_points(vertices, faces, step / 2)
    hull = hull_of(points)
    if hull is None:
        return None
    for axes in (UPRIGHT, SIDEWAYS):
        found = [_along(points, points[hull.vertices], axis, step) for axis in axes]
        worth = [0.0 if cavity is None else cavity.volume for cavity in found]
        if max(worth) > WORTHWHILE * hull.volume:
            return found[int(np.argmax(worth))]
    return None


def rotation_to_z(direction: Axis) -> Array:
    """A rotation, shape (3, 3), that turns a coordinate axis to +z."""
    axis = np.array(direction, dtype=float)
    across = np.roll(np.abs(axis), 1)
    return np.stack([across, np.cross(axis, across), axis])


def _along(points: Array, hull: Array, axis: Axis, step: float) -> Cavity | None:
    """The largest hollow that is open towards an axis; None where all is shallow.

    Args:
        points: On the surface, shape (n, 3).
        hull: Corners of their hull, shape (k, 3).
        axis: One of the six axes.
        step: Distance between the grid's lines, twice that between points.
    """
    rotation = rotation_to_z(axis)
    turned = points @ rotation.T
    low = turned[:, :2].min(axis=0)
    cell = np.minimum(((turned[:, :2] - low) / step).astype(int), GRID - 1)
    floor = np.full((GRID, GRID), -np.inf)
    np.maximum.at(floor, (cell[:, 0], cell[:, 1]), turned[:, 2])
    index = np.moveaxis(np.indices((GRID, GRID)), 0, -1)
    centres = low + (index + 0.5) * step
    roof = span(hull @ rotation.T, centres.reshape(-1, 2))[1].reshape(GRID, GRID)
    seen = np.isfinite(roof) & np.isfinite(floor)
    depth = np.subtract(roof, floor, out=np.zeros_like(roof), where=seen)
    deep = depth > SHALLOWEST
    labels = np.asarray(label(deep)[0])
    if not labels.any():
        return None
    largest = labels == 1 + np.bincount(labels[deep], weights=depth[deep])[1:].argmax()
    places, weight = centres[largest], depth[largest]
    middle = np.append(np.average(places, axis=0, weights=weight), np.median(roof[largest]))
    volume = float(weight.sum() * step**2)
    nearest = np.abs((places - middle[:2]) / step).max(axis=1).min()
    if nearest > 1.0:
        # A groove around something, as between a hat's brim and crown, holds nothing.
        volume *= GROOVE_SHARE
    return Cavity(rotation, middle, places, floor[largest], roof[largest], volume)
