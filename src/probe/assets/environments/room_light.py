"""How much light falls on what a panorama of a room shows."""

from __future__ import annotations

import numpy as np

from probe.assets.environments.casting import Hits
from probe.assets.environments.room import SIDES, Room, WallPatch
from probe.types import Array

_GLOOM = (0.65, 0.3)
"""How much even light a box keeps from a floor it stands on, and how far beside it, metres."""
_CORNER = 0.6
"""Metres from a corner within which a wall grows darker."""

_AXES = {
    **{"front": (1, 1), "right": (0, 1), "back": (1, -1), "left": (0, -1)},
    **{"floor": (2, -1), "ceiling": (2, 1)},
}
"""Axis and direction in which each side of the room lies."""


def linear(colour: str) -> Array:
    """Linear RGB, float32, shape (3,), of "#rrggbb" (IEC 61966-2-1)."""
    srgb = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4).astype(
        np.float32
    )


def radiance(patch: WallPatch) -> Array:
    return linear(patch.colour) * np.float32(patch.glow)


def bounced(room: Room) -> Array:
    """Even light of all bounces, as in an integrating sphere, over pi; shape (3,)."""
    x, y, z = room.size
    areas = np.array([x * z, y * z, x * z, y * z, x * y, x * y])
    colours = np.array([linear(colour) for colour in room.colours])
    mean = 0.92 * (areas[:, None] * colours).sum(axis=0) / areas.sum()
    lights = [p for p in room.patches if p.glow]
    power = sum(p.size[0] * p.size[1] * radiance(p) for p in lights) + np.zeros(3)
    return (power * mean / (1 - mean) / areas.sum()).astype(np.float32)


def corners(room: Room, hits: Hits) -> Array:
    """How much even light gets into the room's corners, 0.5 to 1; shape (h, w)."""
    x, y, z = hits.points
    gaps = np.stack(
        [
            room.size[0] / 2 - np.abs(x),
            room.size[1] / 2 - np.abs(y),
            np.minimum(z, room.size[2] - z),
        ]
    )
    near = np.sort(np.abs(gaps), axis=0)[1]
    return (1 - 0.5 * np.exp(-near / _CORNER * 2)).astype(np.float32)


def unshaded(room: Room, hits: Hits) -> Array:
    """How much even light gets to floor and walls beside what stands there; shape (h, w)."""
    shown = np.ones(hits.side.shape, np.float32)
    bare = hits.side < len(SIDES)
    for box in room.shading:
        low, high = (np.array(end, np.float32)[:, None, None] for end in (box.low, box.high))
        outside = np.maximum(np.maximum(low - hits.points, hits.points - high), 0)
        far = np.sqrt((outside**2).sum(axis=0))
        shown *= np.where(bare, 1 - _GLOOM[0] * np.exp(-far / np.float32(_GLOOM[1])), 1)
    return shown


def falling(patch: WallPatch, room: Room, hits: Hits) -> Array:
    """Light of a patch of radiance 1 at each point, over pi; shape (h, w)."""
    axis, sign = _AXES[patch.side]
    total = np.zeros(hits.side.shape, np.float32)
    spots = _spots(patch, room)
    area = np.float32(patch.size[0] * patch.size[1] / len(spots))
    for spot in spots:
        gap = spot[:, None, None].astype(np.float32) - hits.points
        square = (gap**2).sum(axis=0) + area
        here = np.take_along_axis(gap, hits.axis[None], 0)[0] * hits.sign
        total += np.maximum(here, 0) * np.maximum(gap[axis] * sign, 0) / square**2
    return total * area / np.float32(np.pi)


def _spots(patch: WallPatch, room: Room) -> list[Array]:
    """Points that stand for a light, evenly over it; metres from the middle of the floor."""
    axis, sign = _AXES[patch.side]
    counts = [max(1, min(4, round(edge / 0.8))) for edge in patch.size]
    spots: list[Array] = []
    for i in range(counts[0]):
        for j in range(counts[1]):
            u = patch.at[0] + ((i + 0.5) / counts[0] - 0.5) * patch.size[0]
            v = patch.at[1] + ((j + 0.5) / counts[1] - 0.5) * patch.size[1]
            spots.append(_point(patch.side, u, v, room, axis, sign))
    return spots


def _point(side: str, u: float, v: float, room: Room, axis: int, sign: int) -> Array:
    if axis == 2:
        return np.array([u, v, room.size[2] if sign > 0 else 0.0])
    along = u * (1 if side in ("front", "left") else -1)
    depth = sign * room.size[axis] / 2
    return np.array([along, depth, v] if axis == 1 else [depth, along, v])
