"""What a depth camera would see of a box that is held up: rays cut with planes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from probe_bridge.config import BridgeCamera

from probe.robot_check.box import KnownBox
from probe.robot_check.holding import Shown
from probe.robot_check.places import places
from probe.robot_check.seeing import Depth
from probe.scene.setup import UR5_TABLE
from probe.types import Array, Camera, Pose

BASE = Pose((-0.5, 0.0, 0.2), (0.0, 0.0, 0.0, 1.0))
BOX = KnownBox()
SETUP = replace(UR5_TABLE, picture_px=192)


def told(camera: Camera, pose: Pose, name: str = "front") -> BridgeCamera:
    """A camera as a bridge tells it, perhaps at another pose than its own."""
    size, focal = camera.width_px, camera.focal_px
    middle = size / 2
    return BridgeCamera(name, size, size, focal, focal, middle, middle, pose.position, pose.wxyz)


def seen(camera: Camera, box: KnownBox, world_from_box: Pose | None, noise: float, rng) -> Array:
    """Planar depth of a table at z = 0, and of a box over it, metres, shape (h, w)."""
    rows, columns = np.indices((camera.height_px, camera.width_px))
    rays = camera.rays(np.column_stack([columns.ravel(), rows.ravel()]) + 0.5)
    eye = np.asarray(camera.world_from_camera.position)
    way = rays @ camera.world_from_camera.rotation.T
    depth = -eye[2] / way[:, 2]
    depth[depth < 0] = 9.0
    if world_from_box is not None:
        start = world_from_box.inverse().apply(eye[None])[0]
        along = way @ world_from_box.rotation
        with np.errstate(divide="ignore"):
            one, two = (-box.half - start) / along, (box.half - start) / along
        enter = np.minimum(one, two).max(axis=1)
        leave = np.maximum(one, two).min(axis=1)
        depth = np.where((enter < leave) & (enter > 0), np.minimum(enter, depth), depth)
    depth = depth + noise * depth**2 * rng.standard_normal(len(depth))
    return depth.reshape(rows.shape)


def shown(camera: Camera, described: BridgeCamera, seed: int, slip: float = 0.0) -> list[Shown]:
    """A box at all places before a camera, which its bridge describes in some way."""
    rng = np.random.default_rng(seed)
    found: list[Shown] = []
    for pose in places(SETUP.camera("front"), BOX, SETUP.work_area)[:10]:
        really = pose @ Pose((rng.normal(0.0, slip), 0.0, 0.0)) if slip else pose
        held = seen(camera, BOX, really, 0.001, rng)
        found.append(
            Shown(
                Depth(described, held),
                Depth(described, seen(camera, BOX, None, 0.001, rng)),
                pose,
            )
        )
    return found
