"""Depth pictures that the skills' tests see: upright blocks, by an independent ray cast."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.scene.setup import UR5_TABLE
from probe.types import Array, Frame


@dataclass(frozen=True)
class Block:
    """An upright box: middle of its underside and size, metres."""

    x: float
    y: float
    size: tuple[float, float, float]
    z: float = 0.0

    @property
    def low(self) -> Array:
        return np.array([self.x, self.y, self.z]) - np.array([*self.size[:2], 0.0]) / 2

    @property
    def high(self) -> Array:
        return self.low + np.array(self.size)


def view(blocks: Sequence[Block], size_px: int = 512) -> tuple[Frame, list[Array]]:
    """A frame of blocks on the table, and each one's mask; the slab method (Kay, Kajiya 1986)."""
    camera = UR5_TABLE.top.camera(size_px)
    v, u = np.mgrid[:size_px, :size_px] + 0.5
    rays = (
        camera.rays(np.column_stack([u.ravel(), v.ravel()])) @ camera.world_from_camera.rotation.T
    )
    eye = np.array(camera.world_from_camera.position)
    nearest, owner = -eye[2] / rays[:, 2], np.full(len(rays), -1)
    for number, block in enumerate(blocks):
        with np.errstate(divide="ignore"):
            slabs = np.stack([(block.low - eye) / rays, (block.high - eye) / rays])
        enter, leave = slabs.min(axis=0).max(axis=1), slabs.max(axis=0).min(axis=1)
        hit = (enter < leave) & (enter < nearest)
        nearest, owner = np.where(hit, enter, nearest), np.where(hit, number, owner)
    shape = (size_px, size_px)
    frame = Frame(camera, nearest.reshape(shape).astype(np.float32))
    return frame, [(owner == number).reshape(shape) for number in range(len(blocks))]
