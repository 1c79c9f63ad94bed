"""What each direction of a panorama hits in a room. Knows no light."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from probe.assets.environments.room import SIDES, Furniture, Room
from probe.types import Array, Vector3


@dataclass(frozen=True, eq=False)
class Hits:
    """What is seen: where (m, from the middle of the floor), on what, and which way it faces.

    Attributes:
        points: Shape (3, h, w).
        side: Index of a side of the room, or of a box after them, shape (h, w).
        axis, sign: Of the surface's normal, or of the axis nearest to it, shape (h, w).
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
    middle = (*room.stand, room.eye)
    eye = np.array(middle, np.float32)[:, None, None]
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
        part = _window(box, middle, height)
        enter = _enter_ball if box.round else _enter
        hit, near, face, facing = enter(box, eye, rays[:, *part])
        nearer = hit & (near < distance[part])
        distance[part] = np.where(nearer, near, distance[part])
        side[part] = np.where(nearer, number, side[part])
        axis[part] = np.where(nearer, face, axis[part])
        sign[part] = np.where(nearer, facing, sign[part])
    return Hits(eye + rays * distance, side, axis, sign)


def _window(box: Furniture, eye: Vector3, height: int) -> tuple[slice, slice]:
    """Rows and columns outside which no ray meets a box."""
    sides = [(box.low[k] - eye[k], box.high[k] - eye[k]) for k in range(3)]
    corners = [(x, y) for x in sides[0] for y in sides[1]]
    far = max(math.hypot(*corner) for corner in corners)
    near = math.hypot(*(max(low, -high, 0.0) for low, high in sides[:2]))
    lower, upper = sides[2]
    top = math.atan2(upper, near if upper > 0 else far)
    bottom = math.atan2(lower, far if lower > 0 else near)
    rows = [height * (0.5 - angle / math.pi) for angle in (top, bottom)]
    turns = [math.atan2(x, y) for x, y in corners]
    columns = [height * (turn / math.pi + 1) for turn in turns]
    row = slice(max(0, math.floor(rows[0]) - 1), math.ceil(rows[1]) + 1)
    if near == 0 or max(turns) - min(turns) > math.pi:
        return row, slice(None)
    return row, slice(max(0, math.floor(min(columns)) - 1), math.ceil(max(columns)) + 1)


def _enter(box: Furniture, eye: Array, rays: Array) -> tuple[Array, Array, Array, Array]:
    """Whether rays enter a box from outside, how far off, and through the face of which axis.

    The last is the sign of that face's normal.
    """
    safe = np.where(np.abs(rays) < 1e-9, np.float32(1e-9), rays)
    first = (np.array(box.low, np.float32)[:, None, None] - eye) / safe
    second = (np.array(box.high, np.float32)[:, None, None] - eye) / safe
    entering: Array = np.minimum(first, second)
    leaving: Array = np.maximum(first, second)
    face: Array = np.argmax(entering, axis=0)
    near: Array = np.take_along_axis(entering, face[None], 0)[0]
    facing = -np.sign(np.take_along_axis(rays, face[None], 0)[0])
    return (near > 0) & (near < leaving.min(axis=0)), near, face, facing


def _enter_ball(box: Furniture, eye: Array, rays: Array) -> tuple[Array, Array, Array, Array]:
    """As _enter(), of the ball that fits into a box."""
    low, high = (np.array(end, np.float32)[:, None, None] for end in (box.low, box.high))
    half = (high - low) / 2
    start, way = (eye - (low + high) / 2) / half, rays / half
    square, along = (way * way).sum(axis=0), (way * start).sum(axis=0)
    under: Array = along * along - square * ((start * start).sum(axis=0) - 1)
    near: Array = (-along - np.sqrt(np.maximum(under, 0))) / square
    normal = (start + way * near) / half
    face: Array = np.argmax(np.abs(normal), axis=0)
    return (
        (under > 0) & (near > 0),
        near,
        face,
        np.sign(np.take_along_axis(normal, face[None], 0)[0]),
    )
