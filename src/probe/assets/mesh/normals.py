"""Vertex normals that are smooth over curved parts and sharp at creases. Knows no file format."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from probe.types import Array

WELD = 1e-6
CREASE_DEG = 50.0


def smooth_normals(
    vertices: Array, faces: Array, crease_deg: float = CREASE_DEG
) -> tuple[Array, Array, Array]:
    """Normals of an indexed triangle mesh; vertices on a crease are doubled.

    Corners that meet in one place share a normal if a chain of faces joins them in which no
    two neighbours differ by more than the crease's angle; texture seams don't count. The
    normal is the sum of face normals weighted by the corner's angle (Thuermer and Wuethrich,
    "Computing Vertex Normals from Polygonal Facets", JGT 3(1), 1998).

    Args:
        vertices: Positions in metres, shape (n, 3).
        faces: Vertex indices, shape (m, 3).
        crease_deg: Angle between neighbouring faces from which an edge is sharp.

    Returns:
        The old index of each new vertex, shape (k,); its unit normal, float32, shape (k, 3);
        faces over new vertices, int32, shape (m, 3).
    """
    welded = weld(vertices)[faces]
    directions, angles = _corners(vertices[faces])
    group = _smooth_groups(welded, directions, np.cos(np.radians(crease_deg)))
    sums = np.zeros((group.max() + 1, 3))
    np.add.at(sums, group, np.repeat(directions, 3, axis=0) * angles.reshape(-1, 1))
    lengths = np.linalg.norm(sums, axis=1, keepdims=True)
    normals = np.divide(sums, lengths, out=np.full_like(sums, [0, 0, 1]), where=lengths > 1e-12)
    keys = faces.reshape(-1).astype(np.int64) * len(sums) + group
    unique, inverse = np.unique(keys, return_inverse=True)
    old, group_of_new = unique // len(sums), unique % len(sums)
    new_faces = inverse.reshape(-1, 3).astype(np.int32)
    return old, normals[group_of_new].astype(np.float32), new_faces


def weld(vertices: Array, tolerance: float = WELD) -> Array:
    """Number of the place of each vertex; vertices within a tolerance share one, shape (n,)."""
    cells = np.round(np.asarray(vertices, dtype=np.float64) / tolerance).astype(np.int64)
    return np.unique(cells, axis=0, return_inverse=True)[1].reshape(-1)


def _corners(triangles: Array) -> tuple[Array, Array]:
    """Unit normals, shape (m, 3), and corner angles, shape (m, 3), of triangles (m, 3, 3)."""
    edges = np.roll(triangles, -1, axis=1) - triangles
    normals = np.cross(edges[:, 0], -edges[:, 2])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    incoming = -np.roll(edges, 1, axis=1)
    sine = np.linalg.norm(np.cross(edges, incoming), axis=2)
    return normals, np.arctan2(sine, np.sum(edges * incoming, axis=2))


def _smooth_groups(welded: Array, normals: Array, cosine: float) -> Array:
    """Number of the smooth group of each corner, shape (3 m,)."""
    corner = np.arange(welded.size).reshape(-1, 3)
    ends = np.stack([welded, np.roll(welded, -1, axis=1)], axis=-1).reshape(-1, 2)
    corners = np.stack([corner, np.roll(corner, -1, axis=1)], axis=-1).reshape(-1, 2)
    swapped = ends[:, 0] > ends[:, 1]
    ends[swapped], corners[swapped] = ends[swapped, ::-1], corners[swapped, ::-1]
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    first, second = order[:-1], order[1:]
    same_edge = np.all(ends[first] == ends[second], axis=1)
    smooth = np.sum(normals[first // 3] * normals[second // 3], axis=1) >= cosine
    first, second = first[same_edge & smooth], second[same_edge & smooth]
    rows, columns = corners[first].reshape(-1), corners[second].reshape(-1)
    shape = (welded.size, welded.size)
    links = coo_array((np.ones(len(rows), bool), (rows, columns)), shape=shape)
    return connected_components(links, directed=False)[1]
