"""Split a hollow object's wall into convex parts, one or few for each spherical cell.

The cells lie around the middle of its mouth: seen from there a wall is thin and nearly flat.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from probe.assets.collision.cavity import Cavity
from probe.assets.collision.cuts import Part, half_of
from probe.assets.collision.hulls import hull_volume
from probe.assets.mesh.lattice import lattice_points
from probe.types import Array

SECTORS = 16
BANDS = 3
PROFILE_BINS = 36
STRAIGHT = 1.5e-3
FINENESS = 100
SAME_VOLUME = 1.05
PLACE = 7


def cell_parts(vertices: Array, faces: Array, cavity: Cavity) -> list[Part]:
    """Parts (vertices and faces) of a hollow object's wall, in the object's frame.

    Args:
        vertices: Shape (n, 3), metres.
        faces: Shape (m, 3); need not be watertight.
        cavity: Its cavity.
    """
    rotation = cavity.mouth_from_object
    local = vertices @ rotation.T - cavity.middle
    bands = [0.0, *_band_edges(local, faces), np.pi]
    wedges = [_wedge((local, faces), number) for number in range(SECTORS)]
    parts: list[Part] = []
    for low, high in zip(bands, bands[1:], strict=False):
        layers: list[Part] = []
        for number, wedge in enumerate(wedges):
            layers += _layers(_welded(_band(wedge, number, low, high)))
        parts += _joined(layers)
    return [((points + cavity.middle) @ rotation, triangles) for points, triangles in parts]


def _wedge(part: Part, number: int) -> Part:
    """What lies in one sector around the z axis."""
    first, last = 2 * np.pi * np.array([number, number + 1]) / SECTORS
    part = half_of(part, np.array([-np.sin(first), np.cos(first), 0]), np.zeros(3))
    return half_of(part, np.array([np.sin(last), -np.cos(last), 0]), np.zeros(3))


def _band(wedge: Part, number: int, low: float, high: float) -> Part:
    """What of a wedge lies between two polar angles from -z; flat across the wedge."""
    azimuth = 2 * np.pi * (number + 0.5) / SECTORS
    along = np.array([np.cos(azimuth), np.sin(azimuth), 0])
    for angle, sign in ((low, 1.0), (high, -1.0)):
        if 0 < angle < np.pi:
            normal = np.cos(angle) * along + np.array([0, 0, np.sin(angle)])
            wedge = half_of(wedge, sign * normal, np.zeros(3))
    return wedge


def _welded(part: Part) -> Part:
    """The part with one vertex for each place, and none that no face uses."""
    points, place = np.unique(
        np.round(part[0][part[1].reshape(-1)], PLACE), axis=0, return_inverse=True
    )
    return points, place.reshape(-1, 3)


def _joined(layers: list[Part]) -> list[Part]:
    """One part in place of a band's, where that fills nothing: a cup's flat floor."""
    if not layers:
        return []
    apart = sum(hull_volume(points) for points, _ in layers)
    whole = np.vstack([points[triangles].reshape(-1, 3) for points, triangles in layers])
    if hull_volume(whole) > SAME_VOLUME * apart:
        return layers
    return [(whole, np.arange(len(whole)).reshape(-1, 3))]


def _band_edges(local: Array, faces: Array) -> Array:
    """Polar angles at which the wall's profile bends, fewer than the bands.

    The profile is the median over the sectors of the nearest wall; it is split where it
    departs most from straight lines (Douglas and Peucker, Cartographica 10(2), 1973).
    """
    points = lattice_points(local, faces, float(np.ptp(local, axis=0).max()) / FINENESS)
    radius = np.maximum(np.linalg.norm(points, axis=1), 1e-9)
    polar = np.arccos(np.clip(-points[:, 2] / radius, -1, 1))
    bins = np.minimum((polar / np.pi * PROFILE_BINS).astype(int), PROFILE_BINS - 1)
    azimuth = np.arctan2(points[:, 1], points[:, 0]) % (2 * np.pi)
    sector = (azimuth * SECTORS / (2 * np.pi)).astype(int) % SECTORS
    nearest = np.full((PROFILE_BINS, SECTORS), np.inf)
    np.minimum.at(nearest, (bins, sector), radius)
    kept = np.flatnonzero(np.isfinite(nearest).sum(axis=1) >= SECTORS // 2)
    if len(kept) < 3:
        return np.zeros(0)
    reach = np.array([np.median(row[np.isfinite(row)]) for row in nearest[kept]])
    angle = (kept + 0.5) * np.pi / PROFILE_BINS
    profile = np.stack([reach * np.sin(angle), -reach * np.cos(angle)], axis=1)
    breaks = [0, len(profile) - 1]
    while len(breaks) < BANDS + 1:
        bends = [_bend(profile, a, b) for a, b in zip(breaks, breaks[1:], strict=False)]
        distance, place = max(bends)
        if distance < STRAIGHT:
            break
        breaks = sorted([*breaks, place])
    return angle[breaks[1:-1]]


def _bend(profile: Array, first: int, last: int) -> tuple[float, int]:
    """The largest distance of a profile's points from a chord, and where."""
    chord = profile[last] - profile[first]
    offset = profile[first : last + 1] - profile[first]
    length = max(float(np.linalg.norm(chord)), 1e-9)
    distance = np.abs(offset[:, 0] * chord[1] - offset[:, 1] * chord[0]) / length
    return float(distance.max()), first + int(distance.argmax())


def _layers(part: Part) -> list[Part]:
    """A cell's layers from the middle outwards: a wall's two sides together, a handle apart.

    Going outwards, material begins at a patch that faces the middle and ends at one that
    faces away.
    """
    points, triangles = part
    if not len(triangles):
        return []
    corner = points[triangles]
    centre = corner.mean(axis=1)
    radius = np.maximum(np.linalg.norm(centre, axis=1), 1e-9)
    facing = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    outward = np.sum(facing * centre, axis=1) / radius
    patch = _patches(triangles)
    area = np.bincount(patch, np.abs(outward))
    front = np.bincount(patch, np.clip(-outward, 0, None)) > 0.3 * area
    back = np.bincount(patch, np.clip(outward, 0, None)) > 0.3 * area
    layers: list[list[int]] = [[]]
    closed = False
    for number in np.argsort(np.bincount(patch, radius) / np.bincount(patch), kind="stable"):
        if closed and front[number]:
            layers.append([])
            closed = False
        layers[-1].append(int(number))
        closed = closed or bool(back[number])
    return [_welded((points, triangles[np.isin(patch, layer)])) for layer in layers]


def _patches(triangles: Array) -> Array:
    """Number of the connected patch of each triangle, shape (m,)."""
    rows, columns = triangles[:, [0, 1]].reshape(-1), triangles[:, [1, 2]].reshape(-1)
    count = int(triangles.max()) + 1
    links = coo_array((np.ones(len(rows), bool), (rows, columns)), shape=(count, count))
    return connected_components(links, directed=False)[1][triangles[:, 0]]
