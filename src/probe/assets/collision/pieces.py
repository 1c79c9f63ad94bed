"""Convex pieces for an object's collisions that follow its surface and keep its cavity open."""

from __future__ import annotations

from collections.abc import Sequence

import fast_simplification
import numpy as np
from scipy.spatial import cKDTree

from probe.assets.collision.cavity import Cavity, find_cavity
from probe.assets.collision.cells import cell_parts
from probe.assets.collision.cuts import Part, cut_parts
from probe.assets.collision.hulls import corners, hull_volume
from probe.assets.mesh.mesh import ConvexPiece, TexturedMesh
from probe.assets.mesh.normals import weld
from probe.types import Array

PIECES_VERSION = 4
"""To be raised when the pieces of any mesh change: caches are keyed by it."""

NEARLY_CONVEX = 0.93
MOST_FACES = 2_000
MOST_PIECES = 24
MORE_PIECES = 8
BULKY = 2.0
OPEN_ENOUGH = 0.95


def convex_pieces(mesh: TexturedMesh, hollow: bool) -> tuple[ConvexPiece, ...]:
    """Decompose a mesh into convex pieces of at most 63 corners each; deterministic.

    A nearly convex object is its hull. Others are cut by planes. For hollow ones, cells around
    the mouth are tried first, and whichever leaves more of the cavity open is taken. All
    corners lie on the surface, so that no piece reaches beyond the object's hull.

    Args:
        mesh: Need not be watertight.
        hollow: True if its cavity matters.
    """
    vertices, faces = _welded(mesh)
    cavity = find_cavity(vertices, faces) if hollow else None
    if cavity is not None:
        return _pieces(_hollow_parts(vertices, faces, cavity))
    if solidity(vertices, faces) > NEARLY_CONVEX:
        return _pieces([vertices])
    return _pieces(cut_parts([_reduced(vertices, faces)], MOST_PIECES))


def solidity(vertices: Array, faces: Array) -> float:
    """Volume of a mesh by that of its hull; holes count as closed from the box's middle."""
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    a, b, c = np.moveaxis(vertices[faces] - middle, 1, 0)
    volume = abs(float(np.sum(a * np.cross(b, c)) / 6))
    whole = hull_volume(vertices)
    return volume / whole if whole > 0 else 1.0


def _hollow_parts(vertices: Array, faces: Array, cavity: Cavity) -> list[Array]:
    around = _around(cell_parts(vertices, faces, cavity))
    kept = cavity.kept(around)
    if kept >= OPEN_ENOUGH:
        return around
    across = cut_parts([_reduced(vertices, faces)], MOST_PIECES)
    return across if cavity.kept(across) > kept else around


def _around(cells: Sequence[Part]) -> list[Array]:
    """Points of the cells, those much larger than most (with a handle, say) cut further."""
    points = [vertices[np.unique(faces)] for vertices, faces in cells]
    volume = np.array([hull_volume(part) for part in points])
    large = np.flatnonzero(volume > BULKY * np.median(volume))
    small = [part for number, part in enumerate(points) if number not in large]
    return small + cut_parts([cells[int(number)] for number in large], len(large) + MORE_PIECES)


def _welded(mesh: TexturedMesh) -> Part:
    """Vertices, float64, one for each place, and faces over them; texture seams closed."""
    place = weld(mesh.vertices)
    vertices = np.zeros((place.max() + 1, 3))
    vertices[place] = mesh.vertices
    faces = place[mesh.faces]
    distinct = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    return vertices, faces[distinct]


def _reduced(vertices: Array, faces: Array) -> Part:
    """The mesh with at most 2,000 faces, its vertices still on the surface."""
    if len(faces) <= MOST_FACES:
        return vertices, faces
    fewer = fast_simplification.simplify(vertices, faces, target_count=MOST_FACES)
    nearest = np.asarray(cKDTree(vertices).query(fewer[0])[1])
    return vertices[nearest], np.asarray(fewer[1])


def _pieces(parts: Sequence[Array]) -> tuple[ConvexPiece, ...]:
    found = [corners(points) for points in parts]
    return tuple(ConvexPiece(points) for points in found if points is not None)
