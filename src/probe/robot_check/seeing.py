"""The known box in a camera's pictures: what changes when the hand holds it and when it doesn't."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy import ndimage

from probe.station.fusing import fused
from probe.types import Array, Pose

if TYPE_CHECKING:
    from probe_bridge.client import RobotClient
    from probe_bridge.config import BridgeCamera
    from probe_bridge.description import Picture

LOOKS = 3
"""Pictures that are fused into one."""

_NEARER = 0.015
"""Metres by which a pixel must be nearer with the box than without."""

_AROUND = np.ones((3, 3), dtype=np.int64)
_LEAST_PX = 60
_KEPT = 100
"""Pixels below which nothing was seen of it, and points that are kept."""


@dataclass(frozen=True, eq=False)
class Depth:
    """A depth picture and the camera that its bridge says took it.

    Attributes:
        camera: As the bridge describes it.
        depth: Planar depth, metres, shape (h, w); NaN where there is none.
    """

    camera: BridgeCamera
    depth: Array


@dataclass(frozen=True, eq=False)
class SeenBox:
    """The box, held at one place.

    Attributes:
        camera: Which saw it, as its bridge describes it.
        points: On its surface by the camera, in the camera's frame, metres, shape (n, 3).
        world_from_box: Where the arm's joints say that it is.
    """

    camera: BridgeCamera
    points: Array
    world_from_box: Pose


def look(client: RobotClient, camera: str) -> Depth:
    """What a camera sees now of what is at rest; raises BridgeError."""
    pictures = [client.observe(camera, rgb=False) for _ in range(LOOKS)]
    told = fused([_metres(picture) for picture in pictures])
    depth = told.depth if told.measured is None else np.where(told.measured, told.depth, np.nan)
    return Depth(pictures[0].camera, depth)


def sighted(held: Depth, bare: Depth, world_from_box: Pose) -> SeenBox | None:
    """The box in a picture, by one of the same arm without it; None where it doesn't show."""
    nearer = ndimage.binary_opening(bare.depth - held.depth > _NEARER, _AROUND)
    labels, count = ndimage.label(nearer)
    if not count:
        return None
    sizes = ndimage.sum_labels(nearer, labels, np.arange(1, count + 1))
    mask = labels == 1 + int(np.argmax(sizes))
    if mask.sum() < _LEAST_PX:
        return None
    # The outermost pixels see partly what is behind.
    inner = ndimage.binary_erosion(mask, _AROUND)
    points = lifted(held.camera, held.depth, inner if inner.sum() >= _LEAST_PX else mask)
    return SeenBox(held.camera, points, world_from_box)


def lifted(camera: BridgeCamera, depth: Array, mask: Array) -> Array:
    """Points of some of a mask's pixels in the camera's frame, metres, shape (n, 3)."""
    rows, columns = np.nonzero(mask)
    step = max(1, len(rows) // _KEPT)
    rows, columns = rows[::step], columns[::step]
    z = depth[rows, columns]
    x = (columns + 0.5 - camera.cx) / camera.fx
    y = (rows + 0.5 - camera.cy) / camera.fy
    return np.column_stack([x * z, y * z, z])


def told_pose(camera: BridgeCamera) -> Pose:
    """world_from_camera as the bridge tells it."""
    return Pose(camera.position, camera.wxyz)


def _metres(picture: Picture) -> Array:
    shape = picture.camera.height, picture.camera.width
    return np.frombuffer(picture.depth, "<u2").reshape(shape) * picture.depth_unit
