"""Pictures of one object standing alone on a plain ground."""

from __future__ import annotations

import math

import numpy as np

from probe.assets.mesh.mesh import Material
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera, Pose, Vector3, looking_at

GROUND = TableTop(Material(np.full((1, 1, 3), 170, dtype=np.uint8)), 1.0, (8.0, 8.0))
"""What portraits are taken on; to be loaded with the objects."""

FRONT: Vector3 = (0.45, -1.15, 1.0)

AROUND: tuple[Vector3, ...] = (
    FRONT,
    (1.15, 0.45, 1.0),
    (-0.45, 1.15, 1.0),
    (-1.15, -0.45, 1.0),
    (0.9, -0.9, 0.25),
    (0.01, -0.02, 1.0),
)
"""Six sides: four obliquely from above, one nearly level, one from the top."""

_NEAREST = 0.7
"""Metres from which small things are looked at; from nearer a renderer may cut them off."""


def portrait(
    renderer: Renderer, object_id: str, size: Vector3, towards: Vector3, side_px: int
) -> Array:
    """A loaded object in its resting pose, filling the picture, uint8, shape (side, side, 3).

    Args:
        renderer: Has the object and GROUND loaded.
        object_id: Which.
        size: Its extent, metres.
        towards: Direction from the object to the camera.
        side_px: Height and width.
    """
    extent = float(np.linalg.norm(size))
    middle = np.array([0.0, 0.0, size[2] / 2])
    away = max(_NEAREST, 2 * extent)
    eye = middle + away * np.array(towards) / np.linalg.norm(towards)
    fov_y_deg = math.degrees(2 * math.atan(0.54 * extent / away))
    camera = Camera(looking_at(eye, middle), side_px, side_px, fov_y_deg)
    frame = renderer.draw([PlacedObject(1, object_id, Pose())], camera, rgb=True)
    assert frame.rgb is not None
    return frame.rgb
