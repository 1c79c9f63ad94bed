"""What each direction of a panorama hits in a room. Knows no light."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.assets.environments.room import SIDES, Furniture, Room
from probe.types import Array


@dataclass(frozen=True, eq=False)
class Hits:
    """What is seen: where (m, from the middle of the floor), on what, and which way it faces.

    Attributes:
        points: Shape (3, h, w).
        side: Index of a side of the room, or of a box after them, shape (h, w).
        axis, sign: Of the surface's normal, shape (h, w).
    """

    points: Array
    side: Array
    axis: Array
    sign: Array


def cast(room: Room, height: int) -> Hits:
    """The first surface in every direction; rows from overhead, the middle column to the front."""
    up = np.pi * (0.5 - (np.arange(height) + 0.5) / height)[:, None]
    round_ = (np.pi * ((np.arange(2 * height) + 0.5) / height - 1))[None, :]
    parts = [np.cos(up) * np.sin(round_), np.cos(up) * np.cos(round_), np.sin(up) + 0 * round_]
    rays = np.stack(parts).astype(np.float32)
    eye = np.array([0.0, 0.0, room.eye], np.float32)[:, None, None]
    high = np.array([room.size[0] / 2, room.size[1] / 2, room.size[2]], np.float32)
    low = np.array([-high[0], -high[1], 0], np.float32)
    ahead = rays > 0
    wall = np.where(ahead, high[:, None, None], low[:, None, None])
    reach = (wall - eye) / np.where(np.abs(rays) < 1e-9, 1e-9, rays)
    axis = np.argmin(reach, axis=0)
    distance = np.take_along_axis(reach, axis[None], 0)[0]
    sign = np.where(np.take_along_axis(ahead, axis[None], 0)[0], -1, 1)
    numbers = np.array([[3, 2, 4], [1, 0, 5]])
    side = numbers[(sign < 0).astype(int), axis]
    for number, box in enumerate(room.boxes, start=len(SIDES)):
        hit, near, face = _enter(box, eye, rays)
        nearer = hit & (near < distance)
        distance = np.where(nearer, near, distance)
        side = np.where(nearer, number, side)
        axis = np.where(nearer, face, axis)
        facing = -np.sign(np.take_along_axis(rays, face[None], 0)[0])
        sign = np.where(nearer, facing, sign)
    return Hits(eye + rays * distance, side, axis, sign)


def _enter(box: Furniture, eye: Array, rays: Array) -> tuple[Array, Array, Array]:
    """Whether rays enter a box from outside, how far off, and through the face of which axis."""
    safe = np.where(np.abs(rays) < 1e-9, np.float32(1e-9), rays)
    first = (np.array(box.low, np.float32)[:, None, None] - eye) / safe
    second = (np.array(box.high, np.float32)[:, None, None] - eye) / safe
    entering: Array = np.minimum(first, second)
    leaving: Array = np.maximum(first, second)
    face: Array = np.argmax(entering, axis=0)
    near: Array = np.take_along_axis(entering, face[None], 0)[0]
    return (near > 0) & (near < leaving.min(axis=0)), near, face
