"""Meshes of one material from turned, rounded and swept solids. Knows no robot."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.assets.procedural.form.cuboid import rounded_box
from probe.assets.procedural.form.curves import filleted, smoothed
from probe.assets.procedural.form.lathe import Base, turn
from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.form.sweep import section, sweep
from probe.types import Array, Pose, Vector3, quaternion_of

_ROUND = Base(segments=48)
_BAR = section(7.0, 33)
"""Outline of a bar: a rectangle with rounded corners."""


def turned(corners: Sequence[tuple[float, float, float]], start: Vector3, end: Vector3) -> Sheet:
    """A solid of revolution about the line from one point towards another.

    Args:
        corners: Its profile from axis to axis: distance from the line, distance along it from
            `start`, and the radius of the rounding there, metres.
        start: Of the line.
        end: Gives the direction alone.
    """
    (sheet,) = turn([filleted(np.array(corners))], _ROUND, [False])
    return sheet.moved(_along(start, end))


def drum(start: Vector3, end: Vector3, radius: float, fillet: float) -> Sheet:
    """A cylinder between two points with rounded edges, metres."""
    length = float(np.linalg.norm(np.subtract(end, start)))
    rim = [(radius, 0.0, fillet), (radius, length, fillet)]
    return turned([(0.0, 0.0, 0.0), *rim, (0.0, length, 0.0)], start, end)


def capsule(start: Vector3, end: Vector3, radius: float) -> Sheet:
    """A cylinder between two points with half a ball at each end, metres."""
    length = float(np.linalg.norm(np.subtract(end, start)))
    angles = np.linspace(0.0, np.pi / 2, 9)
    low = np.column_stack([radius * np.sin(angles), -radius * np.cos(angles)])
    high = np.column_stack([radius * np.cos(angles), length + radius * np.sin(angles)])
    profile = np.vstack([low, high])
    profile[[0, -1], 0] = 0.0
    (sheet,) = turn([profile], _ROUND, [False])
    return sheet.moved(_along(start, end))


def block(centre: Vector3, half_size: Vector3, radius: float) -> list[Sheet]:
    """A box along the axes with rounded edges, metres."""
    down = Pose((centre[0], centre[1], centre[2] - half_size[2]))
    sides = rounded_box(2 * np.array(half_size), radius)
    return [side.moved(down) for side in sides.values()]


def bar(path: Sequence[Vector3], half: tuple[float, float], fillet: float = 0.002) -> Sheet:
    """A bar along a curve through points in a plane of constant x; its section is a rectangle.

    Args:
        path: The points, metres.
        half: Half of its width along x, and half of its thickness in the plane.
        fillet: Of both ends.
    """
    centres = smoothed(np.array(path, dtype=float), 0.004)
    size = np.tile(np.array([half[1], half[0]]), (len(centres), 1))
    return sweep(centres, size, _BAR, np.array([1.0, 0.0, 0.0]), fillet)


def joined(sheets: Sequence[Sheet], surface: Material) -> TexturedMesh:
    """One mesh of one material."""
    counts = [sheet.points[..., 0].size for sheet in sheets]
    starts = np.cumsum([0, *counts])[:-1]
    faces = [sheet.faces + start for sheet, start in zip(sheets, starts, strict=True)]
    return TexturedMesh(
        vertices=np.vstack([each.points.reshape(-1, 3) for each in sheets]).astype(np.float32),
        normals=np.vstack([each.normals.reshape(-1, 3) for each in sheets]).astype(np.float32),
        uvs=np.zeros((sum(counts), 2), np.float32),
        faces=np.vstack(faces).astype(np.int32),
        surface=surface,
    )


def _along(start: Vector3, end: Vector3) -> Pose:
    """A pose at a point whose z points to another."""
    z = np.subtract(end, start) / np.linalg.norm(np.subtract(end, start))
    aside: Array = np.eye(3)[int(np.argmin(np.abs(z)))]
    x = np.cross(aside, z)
    x /= np.linalg.norm(x)
    return Pose.of(np.array(start), quaternion_of(np.column_stack([x, np.cross(z, x), z])))
