"""How an object comes to rest on a table: the lying pose of its hull that it would topple into."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull, QhullError
from scipy.spatial.transform import Rotation

from probe.assets.collision.hulls import hull_of
from probe.types import Array

STEADY_DEG = 1.0
"""What topples at less rolls on; the least steady of 165 scans stands 1.1 degrees."""

_ROLLS_DEG = 45.0
"""How far something unsteady rolls at most to a face on which it stays."""

_FLAT = 2e-4
"""Corners of the hull at most this far (metres) above the table touch it."""


@dataclass(frozen=True, eq=False)
class Rest:
    """A lying pose.

    Attributes:
        turn: Rotation, shape (3, 3), from the pose as given into this one.
        turned_deg: Its angle.
        tilt_deg: By how much it can be tilted before it topples further.
    """

    turn: Array
    turned_deg: float
    tilt_deg: float


def rest_of(vertices: Array) -> Rest | None:
    """The lying pose into which a body topples from the one it is given in.

    A body rests on a facet of its convex hull if its centre of mass lies above it. From the
    pose as given, it is turned onto the facet that the vertical through the centre of mass
    leaves it by; that brings the centre lower, so that the steps come to an end, on a facet on
    which it stays. From one on which it stays at a tilt of less than a degree only, it rolls on to
    the nearest that holds it better. The hull stands for the body's mass: uniform, cavities filled.

    Args:
        vertices: Shape (n, 3), metres, z up.

    Returns:
        None if they have no volume.
    """
    hull = hull_of(vertices)
    if hull is None or not hull.volume > 0:
        return None
    corners = vertices[hull.vertices]
    centre = _centroid(vertices[hull.simplices], corners.mean(axis=0))
    normals, offsets = hull.equations[:, :3], hull.equations[:, 3]
    heights = -(normals @ centre + offsets)
    lying = _Lying(corners, centre, normals, offsets, heights)
    facet = _toppled(normals, heights)
    if lying.tilt_deg(facet) < STEADY_DEG:
        facet = _rolled(lying, facet)
    down = normals[facet]
    turned = math.degrees(math.acos(float(np.clip(-down[2], -1, 1))))
    return Rest(_turn_down(down), turned, lying.tilt_deg(facet))


@dataclass(frozen=True, eq=False)
class _Lying:
    """A hull and its centre of mass: corners (n, 3), centre (3,), of the facets (k, 3) and (k,)."""

    corners: Array
    centre: Array
    normals: Array
    offsets: Array
    heights: Array

    def tilt_deg(self, facet: int) -> float:
        """By how much it can be tilted on a facet before it topples further."""
        down = self.normals[facet]
        touching = self.corners[self.corners @ down + self.offsets[facet] > -_FLAT]
        margin = _margin(touching - self.centre, down)
        return math.degrees(math.atan2(margin, float(self.heights[facet])))


def _rolled(lying: _Lying, facet: int) -> int:
    """The facet nearest to an unsteady one on which it stays; that one itself if there is none.

    A ball of facets rolls from one to the next until it lies on a steadier one; which it meets
    first by toppling depends on how it was held, so that a ball would be refused in one pose and
    let in in another.
    """
    along = lying.normals @ lying.normals[facet]
    near = np.flatnonzero(along >= math.cos(math.radians(_ROLLS_DEG)))
    for other in near[np.argsort(-along[near], kind="stable")]:
        if lying.tilt_deg(int(other)) >= STEADY_DEG:
            return int(other)
    return facet


def _toppled(normals: Array, heights: Array) -> int:
    """The facet that it ends on, from the pose as given.

    Args:
        normals: Of the facets, outwards, shape (k, 3).
        heights: Distance of the centre of mass from each facet's plane, shape (k,).
    """
    down, facet = np.array([0.0, 0.0, -1.0]), -1
    while True:
        along = normals @ down
        towards = along > 1e-9
        distance = np.full(len(heights), np.inf)
        distance[towards] = heights[towards] / along[towards]
        beneath = int(distance.argmin())
        if facet >= 0 and heights[beneath] >= heights[facet] - 1e-12:
            return facet
        facet, down = beneath, normals[beneath]


def _centroid(triangles: Array, inside: Array) -> Array:
    """Centre of the volume that triangles (k, 3, 3) enclose, from a point inside; shape (3,)."""
    a, b, c = np.moveaxis(triangles - inside, 1, 0)
    volumes = np.abs(np.sum(a * np.cross(b, c), axis=1))
    return inside + (volumes[:, None] * (a + b + c)).sum(axis=0) / (4 * volumes.sum())


def _margin(touching: Array, down: Array) -> float:
    """Distance, metres, of the foot of the centre of mass from the border of what it stands on.

    Args:
        touching: What touches the table, from the centre of mass, shape (k, 3).
        down: Unit vector.
    """
    plane = np.linalg.svd(down[None])[2][1:]
    try:
        border = ConvexHull(touching @ plane.T)
    except (QhullError, ValueError):
        return 0.0
    return float(max(0.0, -border.equations[:, 2].max()))


def _turn_down(direction: Array) -> Array:
    """The smallest rotation, shape (3, 3), that brings a unit vector to -z."""
    axis = np.cross(direction, [0.0, 0.0, -1.0])
    sine = float(np.linalg.norm(axis))
    if sine < 1e-12:
        return np.eye(3) if direction[2] < 0 else np.diag([1.0, -1.0, -1.0])
    angle = math.atan2(sine, -float(direction[2]))
    return Rotation.from_rotvec(axis / sine * angle).as_matrix()
