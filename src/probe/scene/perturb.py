"""Small seeded changes to how a scene looks or lies; no physics, no pixels.

Each takes a generator and a range and returns a new value. Their defaults are what a robot's
set-up drifts by between two days; a caller may ask for less or more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from probe.scene.lighting import Lighting, hdri
from probe.scene.scene import Scene
from probe.types import Array, Camera, Pose


@dataclass(frozen=True)
class ViewRange:
    """How far a camera may stray.

    Attributes:
        shift: Sideways and along the table, metres either way.
        height: Up or down, metres either way.
        tilt: Radians about any axis across the line of sight.
    """

    shift: float = 0.03
    height: float = 0.05
    tilt: float = math.radians(2)


@dataclass(frozen=True)
class PoseRange:
    """How far an object may be moved: metres along x and y, radians about the vertical."""

    shift: float = 0.01
    turn: float = math.radians(10)


CameraName = Literal["fixed", "shifted", "raised", "tilted", "moved"]
"""How a camera strays: not at all, or in the ways that VIEW_RANGES allows."""

_WIDE = ViewRange()

VIEW_RANGES: dict[CameraName, ViewRange] = {
    "fixed": ViewRange(0.0, 0.0, 0.0),
    "shifted": ViewRange(_WIDE.shift, 0.0, 0.0),
    "raised": ViewRange(0.0, _WIDE.height, 0.0),
    "tilted": ViewRange(0.0, 0.0, _WIDE.tilt),
    "moved": _WIDE,
}
"""By name: along the table, up or down, about the line of sight's normals, or all at once."""


def moved_view(camera: Camera, rng: np.random.Generator, within: ViewRange = ViewRange()) -> Camera:
    """The same camera, shifted, raised or lowered, and tilted."""
    most = (within.shift, within.shift, within.height)
    shift = rng.uniform(-1, 1, 3) * most
    about, angle = rng.uniform(-math.pi, math.pi), rng.uniform(-1, 1) * within.tilt
    axis = np.array([math.cos(about), math.sin(about), 0.0])
    pose = camera.world_from_camera
    tilted = pose @ Pose.of(np.zeros(3), _turn(axis, angle))
    moved = Pose.of(np.array(pose.position) + shift, np.array(tilted.wxyz))
    return replace(camera, world_from_camera=moved)


def other_table(scene: Scene, tables: Sequence[str], rng: np.random.Generator) -> Scene:
    """The same scene on another table.

    Raises:
        ValueError: There is no other table.
    """
    others = [table for table in tables if table != scene.table]
    if not others:
        raise ValueError(f"no table but {scene.table}")
    return replace(scene, table=others[int(rng.integers(len(others)))])


def jittered(scene: Scene, rng: np.random.Generator, within: PoseRange = PoseRange()) -> Scene:
    """Every object a little moved and turned about its own upright.

    Objects may touch, float or overlap now: settle the scene again before it is used.
    """
    objects = list(scene.objects)
    for index, item in enumerate(objects):
        x, y = rng.uniform(-1, 1, 2) * within.shift
        upright = Pose.of(
            np.zeros(3), _turn(np.array([0.0, 0.0, 1.0]), rng.uniform(-1, 1) * within.turn)
        )
        turned = (upright @ Pose((0.0, 0.0, 0.0), item.pose.wxyz)).wxyz
        position = np.array(item.pose.position) + (x, y, 0.0)
        objects[index] = replace(item, pose=Pose.of(position, np.array(turned)))
    return replace(scene, objects=tuple(objects))


def any_lighting(names: Sequence[str], rng: np.random.Generator) -> Lighting:
    """One of some surroundings, turned anyhow; names as environment_names lists them.

    Raises:
        ValueError: There is none to choose.
    """
    if not names:
        raise ValueError("no surroundings to choose from")
    return hdri(names[int(rng.integers(len(names)))], float(rng.uniform(-math.pi, math.pi)))


def _turn(axis: Array, angle: float) -> Array:
    """Quaternion wxyz of a turn about a unit vector, radians."""
    return np.array([math.cos(angle / 2), *(math.sin(angle / 2) * axis)])
