"""Where things stand: the one place for the sizes and poses of the set-up. Metres, world frame.

The origin is the middle of the table's top, x points away from the robot, y to its left.
The picture's right is +x and its top is +y.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.types import Camera, Pose, looking_at

WORK_AREA = 0.50
"""Edge of the square, centred on the origin, in which objects are dropped and settle."""

TABLE_SIZE = (1.6, 1.4)
"""Extent of the table top along x and y."""

CAMERA_HEIGHT = 1.20
"""Height of the top-down camera above the table."""

VIEW_SIZE = 0.58
"""Edge of the square of table that the top-down camera sees."""

PICTURE_PX = 1024
"""Edge of the picture in pixels."""

BASKET_POSITION = (-0.55, -0.44, 0.0)
"""Middle of the basket's floor: beside the arm, outside the picture; few pushes meet it there."""

BASKET_SIZE = (0.36, 0.36, 0.16)
"""Inner extent of the basket along x, y, and the height of its walls."""

FLOOR_DEPTH = 0.75
"""How far below the table's top the floor lies."""


FRONT_EYE = (0.0, -0.92, 0.50)
"""Where the front camera stands: before the edge that the top-down picture shows below."""

FRONT_TARGET = (0.0, 0.0, 0.11)
"""What it looks at."""

FRONT_FOV_DEG = 40.0

View = Literal["top", "front"]


def view_camera(view: View, size_px: int = PICTURE_PX) -> Camera:
    """A fixed camera by name."""
    return top_camera(size_px) if view == "top" else front_camera(size_px)


def front_camera(size_px: int = PICTURE_PX) -> Camera:
    """The fixed oblique camera; the picture's right is world +x, what is far off is +y."""
    pose = looking_at(np.array(FRONT_EYE), np.array(FRONT_TARGET))
    return Camera(pose, size_px, size_px, FRONT_FOV_DEG)


def top_camera(size_px: int = PICTURE_PX) -> Camera:
    """The fixed top-down camera; the picture's right is world +x, its top is world +y."""
    fov = 2 * math.degrees(math.atan(VIEW_SIZE / 2 / CAMERA_HEIGHT))
    looking_down = Pose((0.0, 0.0, CAMERA_HEIGHT), (0.0, 1.0, 0.0, 0.0))
    return Camera(looking_down, size_px, size_px, fov)
