"""Which objects lie outside what a camera sees."""

from __future__ import annotations

import itertools

import numpy as np

from probe.types import Array, Camera, Pose

_SPARE_PX = 8.0
"""Pixels beyond the picture's edge that count as seen, so that rounding hides nothing."""


def may_show(bounds: tuple[Array, Array], pose: Pose, camera: Camera) -> bool:
    """Whether a box could show in a picture: False only if it lies wholly beyond one of its edges.

    Args:
        bounds: Its lowest and highest corner, metres, each of shape (3,), in its own frame.
        pose: world_from_object.
        camera: Sees it.
    """
    corners = np.array(list(itertools.product(*np.array(bounds, float).T)))
    x, y, z = camera.world_from_camera.inverse().apply(pose.apply(corners)).T
    right = z * (camera.width_px / 2 + _SPARE_PX) / camera.focal_px
    below = z * (camera.height_px / 2 + _SPARE_PX) / camera.focal_px
    beyond = (x > right, x < -right, y > below, y < -below)
    return not any(bool(outside.all()) for outside in beyond)
