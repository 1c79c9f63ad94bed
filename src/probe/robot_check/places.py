"""Where the known box is held before a camera. Moves nothing."""

from __future__ import annotations

import numpy as np

from probe.robot_check.box import KnownBox
from probe.types import Array, Camera, Pose

MOST = 10
"""Places that one camera is shown the box at."""

_OUT = (0.55, 0.0, -0.55)
_HEIGHTS = (0.10, 0.22, 0.16)
"""Of the box's underside above the table, metres."""

_TURN = 37.0
"""Degrees by which each place's box is turned further; a quarter brings the hand back."""

_INSIDE = 0.06
"""Share of the picture's edge that the box stays away from its borders."""


def places(camera: Camera, box: KnownBox, work_area: float) -> list[Pose]:
    """Poses of the box, spread over the work area and over heights, that a camera shows whole.

    Neighbours differ in height and turn.

    Args:
        camera: Where the set-up says that it stands.
        box: What is held.
        work_area: Edge of the square around the origin, metres.
    """
    found: list[Pose] = []
    grid = [(x, y) for x in _OUT for y in _OUT]
    for layer in range(len(_HEIGHTS)):
        for number, (x, y) in enumerate(grid):
            height = _HEIGHTS[(number + layer) % len(_HEIGHTS)]
            middle = np.array([x * work_area / 2, y * work_area / 2, height + box.half[2]])
            angle = np.radians((_TURN * (number + layer)) % 90.0 - 45.0)
            pose = Pose.of(middle, np.array([np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)]))
            if _shows(camera, box, pose):
                found.append(pose)
    return found


def yaw_of(pose: Pose) -> float:
    """Turn about the vertical, radians."""
    rotation: Array = pose.rotation
    return float(np.arctan2(rotation[1, 0], rotation[0, 0]))


def _shows(camera: Camera, box: KnownBox, pose: Pose) -> bool:
    uv = camera.project(pose.apply(box.surface(1.0)))
    edge = _INSIDE * camera.height_px
    size = np.array([camera.width_px, camera.height_px])
    return bool(((uv > edge) & (uv < size - edge)).all())
