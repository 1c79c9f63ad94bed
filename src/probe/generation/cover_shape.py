"""How an object lies as a cover, measured on its mesh. Knows no library."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from probe.assets.cache import content_key
from probe.assets.collision.cavity import Cavity, find_cavity
from probe.assets.mesh.lattice import lattice_points
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.recipes import recipe
from probe.assets.spec import ObjectSpec
from probe.types import Array, quaternion_of

_DEEP = 0.03
_FILLED = 0.7
_GRID = 24
_MIDDLE = slice(_GRID // 4, _GRID - _GRID // 4)
_HALF_TURN = np.diag([1.0, -1.0, -1.0])


@dataclass(frozen=True)
class CoverShape:
    """An object's shape, lying so that it covers what is beneath; see Cover.

    Attributes:
        numbers: Orientation (w, x, y, z), extent (x, y, z), middle (x, y), width, depth.
        closed: Whether a flat thing has no hole near its middle.
    """

    numbers: tuple[float, ...]
    closed: bool = True


def shape_recipe(spec: ObjectSpec) -> str:
    """A hash of all that decides an object's shape as a cover, except for its mesh."""
    code = [recipe("probe.assets.collision"), recipe("probe.assets.mesh")]
    return content_key(*code, Path(__file__).read_bytes(), str(spec.hollow), str(spec.size))


def shape_of(spec: ObjectSpec, mesh: TexturedMesh) -> CoverShape | None:
    """How an object lies as a cover; None if it is of no use as one.

    A hollow one lies with its mouth down, a flat one on its largest side.
    """
    cavity = find_cavity(mesh.vertices, mesh.faces) if spec.hollow else None
    if cavity is not None:
        down = _HALF_TURN @ cavity.mouth_from_object
        room = _room(cavity)
        if room[1] >= _DEEP:
            return CoverShape(_lying(mesh, down, _HALF_TURN @ cavity.middle, room))
    upwards = int(np.argmin(spec.size))
    down = np.roll(np.eye(3), 2 - upwards, axis=0)
    filled = _filled(mesh.vertices @ down.T, mesh.faces)
    if filled.mean() < _FILLED:
        return None
    closed = bool(filled[_MIDDLE, _MIDDLE].all())
    return CoverShape(_lying(mesh, down, None, (0.0, 0.0)), closed)


def packed(shape: CoverShape | None) -> dict[str, Array]:
    """As arrays; every digit is kept."""
    if shape is None:
        return {}
    return {"numbers": np.array(shape.numbers), "closed": np.array(shape.closed)}


def unpacked(stored: Mapping[str, Array]) -> CoverShape | None:
    """The shape that was packed."""
    if not stored:
        return None
    return CoverShape(tuple(stored["numbers"].tolist()), bool(stored["closed"]))


def _filled(corners: Array, faces: Array) -> Array:
    """Which cells of the bounding rectangle, seen along z, a mesh fills, bool, shape (n, n).

    A disc fills 0.785 of them.
    """
    points = lattice_points(corners, faces, float(np.ptp(corners[:, :2], axis=0).min()) / _GRID)
    low, extent = points[:, :2].min(axis=0), np.ptp(points[:, :2], axis=0)
    cells = np.minimum((points[:, :2] - low) / extent * _GRID, _GRID - 1).astype(int)
    filled = np.zeros((_GRID, _GRID), dtype=bool)
    filled[cells[:, 0], cells[:, 1]] = True
    return filled


def _lying(
    mesh: TexturedMesh, rotation: Array, middle: Array | None, room: tuple[float, float]
) -> tuple[float, ...]:
    corners = mesh.vertices @ rotation.T
    low, high = corners.min(axis=0), corners.max(axis=0)
    centre = (low + high) / 2
    off = (middle if middle is not None and room[1] else centre) - centre
    parts = (*quaternion_of(rotation), *(high - low), *off[:2], *room)
    return tuple(float(part) for part in parts)


def _room(cavity: Cavity) -> tuple[float, float]:
    """Width and depth in metres of the part of a cavity that is at least half as deep as it gets.

    The width is that of a disc of the same area.
    """
    depths = cavity.roof - cavity.floor
    cell = cavity.volume / float(depths.sum())
    deep = depths >= depths.max() / 2
    width = 2 * math.sqrt(np.count_nonzero(deep) * cell / math.pi)
    return width, float(np.median(depths[deep]))
