"""Paints a room's panorama: what each direction hits, and how much light falls there.

Lights are rectangles; what they reach by one bounce and more counts as even. No shadows.
"""

from __future__ import annotations

import numpy as np

from probe.assets.environments.casting import Hits, cast
from probe.assets.environments.room import SIDES, Room, WallPatch
from probe.types import Array

HEIGHT_PX = 512
_FINE = 2
"""Pixels are means of so many painted ones, across and down."""
_GLOOM = (0.65, 0.3)
"""How much even light a box keeps from a floor it stands on, and how far beside it, metres."""
_CORNER = 0.6
"""Metres from a corner within which a wall grows darker."""

_AXES = {
    **{"front": (1, 1), "right": (0, 1), "back": (1, -1), "left": (0, -1)},
    **{"floor": (2, -1), "ceiling": (2, 1)},
}
"""Axis and direction in which each side of the room lies."""


def paint_room(room: Room) -> Array:
    """Linear radiance, float32, shape (h, 2 h, 3)."""
    fine = sketch_room(room, HEIGHT_PX * _FINE)
    return fine.reshape(HEIGHT_PX, _FINE, 2 * HEIGHT_PX, _FINE, 3).mean(axis=(1, 3))


def sketch_room(room: Room, height: int = HEIGHT_PX) -> Array:
    """As paint_room(), with edges that aren't smoothed: in a quarter of the time."""
    hits = cast(room, height)
    colours = [*room.colours, *(box.colour for box in room.boxes)]
    albedo = 0.92 * np.array([linear(c) for c in colours], np.float32)[hits.side]
    albedo *= _laid(room, hits)[..., None]
    glow = np.zeros(albedo.shape, np.float32)
    for patch in room.patches:
        _stick(patch, room, hits, albedo, glow)
    light = _bounced(room) * (_corners(room, hits) * _open(room, hits))[..., None]
    for patch in room.patches:
        if patch.glow:
            light += _falling(patch, room, hits)[..., None] * _radiance(patch)
    return np.where(glow > 0, glow, albedo * light)


def linear(colour: str) -> Array:
    """Linear RGB, float32, shape (3,), of "#rrggbb" (IEC 61966-2-1)."""
    srgb = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4).astype(
        np.float32
    )


def _laid(room: Room, hits: Hits) -> Array:
    """Brightness of the floor's planks or tiles, 1 elsewhere; shape (h, w)."""
    kind, width = room.pattern
    x, y = hits.points[0], hits.points[1]
    if kind == "plain":
        return np.ones(hits.side.shape, np.float32)
    row = np.floor(y / width).astype(int)
    long = width * (1 if kind == "tiles" else 8)
    column = np.floor(x / long + (0 if kind == "tiles" else row * 0.37)).astype(int)
    tones = np.random.default_rng(0).uniform(0.8, 1.12, (64, 64)).astype(np.float32)
    laid = tones[row % 64, column % 64] if kind == "planks" else 1 - 0.25 * ((row + column) % 2)
    joint: Array = (y / width - row < 0.03) | (x / long - np.floor(x / long) < 0.03 * width / long)
    shown: Array = np.where(joint, 0.6, laid)
    return np.where(hits.side == SIDES.index("floor"), shown, 1)


def _across(side: str, points: Array) -> tuple[Array, Array]:
    """Coordinates on a side as Patch has them, metres."""
    x, y, z = points
    if side in ("floor", "ceiling"):
        return x, y
    return {"front": x, "right": -y, "back": -x, "left": y}[side], z


def _stick(patch: WallPatch, room: Room, hits: Hits, albedo: Array, glow: Array) -> None:
    """Put a patch on its side, in place."""
    u, v = _across(patch.side, hits.points)
    on = hits.side == SIDES.index(patch.side)
    du, dv = np.abs(u - patch.at[0]), np.abs(v - patch.at[1])
    half_u, half_v = patch.size[0] / 2, patch.size[1] / 2
    framed = on & (du < half_u + patch.frame) & (dv < half_v + patch.frame)
    albedo[framed] = linear(patch.frame_colour)
    pane = on & (du < half_u) & (dv < half_v)
    for place, size, count in (
        (u - patch.at[0], 2 * half_u, patch.panes[0]),
        (v - patch.at[1], 2 * half_v, patch.panes[1]),
    ):
        within = (place / size + 0.5) * count % 1.0
        bar = 0.5 * patch.frame / (size / count)
        pane &= (count == 1) | (np.minimum(within, 1 - within) > bar)
    albedo[pane] = linear(patch.colour)
    if patch.glow:
        glow[pane] = _radiance(patch)


def _radiance(patch: WallPatch) -> Array:
    return linear(patch.colour) * np.float32(patch.glow)


def _bounced(room: Room) -> Array:
    """Even light of all bounces, as in an integrating sphere, over pi; shape (3,)."""
    x, y, z = room.size
    areas = np.array([x * z, y * z, x * z, y * z, x * y, x * y])
    colours = np.array([linear(colour) for colour in room.colours])
    mean = 0.92 * (areas[:, None] * colours).sum(axis=0) / areas.sum()
    lights = [p for p in room.patches if p.glow]
    power = sum(p.size[0] * p.size[1] * _radiance(p) for p in lights) + np.zeros(3)
    return (power * mean / (1 - mean) / areas.sum()).astype(np.float32)


def _corners(room: Room, hits: Hits) -> Array:
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


def _open(room: Room, hits: Hits) -> Array:
    """How much even light gets to floor and walls beside what stands there; shape (h, w)."""
    shown = np.ones(hits.side.shape, np.float32)
    bare = hits.side < len(SIDES)
    for box in room.shading:
        low, high = (np.array(end, np.float32)[:, None, None] for end in (box.low, box.high))
        outside = np.maximum(np.maximum(low - hits.points, hits.points - high), 0)
        far = np.sqrt((outside**2).sum(axis=0))
        shown *= np.where(bare, 1 - _GLOOM[0] * np.exp(-far / np.float32(_GLOOM[1])), 1)
    return shown


def _falling(patch: WallPatch, room: Room, hits: Hits) -> Array:
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
