"""Whether a scan looks like all of its object, or like what was left of it. Geometry alone."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from probe.assets.collision.hulls import hull_of
from probe.assets.mesh.lattice import places, spots
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.normals import weld
from probe.types import Array

BARE = 0.45
"""Surface by that of the hull below which most of a thing is missing, or it is made of wire. A
whole one has about as much as its hull; the barest of 165 scans, a dish rack, has 0.55."""

LOOSE = 0.02
"""Share of the surface from which a piece apart from the rest counts."""

APART = 0.005
"""Metres that a piece is away from the rest, spots on both being compared."""

_SPOTS = 4000


def broken_parts(mesh: TexturedMesh) -> str | None:
    """Why an object looks like an incomplete reconstruction, or None if it doesn't."""
    vertices, faces = mesh.vertices.astype(np.float64), mesh.faces
    a, b, c = np.moveaxis(vertices[faces], 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    hull = hull_of(vertices)
    share = 1.0 if hull is None else float(areas.sum() / hull.area)
    loose = _loose_pieces(vertices, faces, areas, weld(mesh.vertices))
    bare = f"has {share:.0%} of the surface of its hull"
    if loose:
        more = f" and {bare}" if share < BARE else ""
        return f"falls into {loose + 1} pieces that don't touch{more}: is the scan whole?"
    return f"{bare}: is it of wire, or is only its rim there?" if share < BARE else None


def _loose_pieces(vertices: Array, faces: Array, areas: Array, place: Array) -> int:
    """How many pieces of some size lie apart from the largest and all others."""
    corners = place[faces]
    ends = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]]])
    count = int(place.max()) + 1
    graph = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    piece = np.asarray(connected_components(graph, directed=False)[1])[corners[:, 0]]
    sizes = np.bincount(piece, weights=areas)
    large = np.flatnonzero(sizes >= LOOSE * areas.sum())
    points = [_points(vertices, faces[piece == number]) for number in large]
    apart = 0
    for number, mine in enumerate(points):
        others = [other for at, other in enumerate(points) if at != number]
        if others and np.min(cKDTree(np.concatenate(others)).query(mine)[0]) > APART:
            apart += 1
    return min(apart, len(points) - 1)


def _points(vertices: Array, faces: Array) -> Array:
    """Corners and spots of a piece: of large triangles the corners alone tell little."""
    spread = places(vertices, faces, *spots(vertices, faces, _SPOTS))
    return np.concatenate([vertices[np.unique(faces)], spread])
