"""Paints a room's panorama: what each direction hits, and how much light falls there.

Lights are rectangles; what they reach by one bounce and more counts as even. No shadows.
"""

from __future__ import annotations

import numpy as np

from probe.assets.environments.casting import Hits, cast
from probe.assets.environments.room import SIDES, Room, WallPatch
from probe.assets.environments.room_light import (
    bounced,
    corners,
    falling,
    linear,
    radiance,
    unshaded,
)
from probe.types import Array

HEIGHT_PX = 512
_FINE = 2
"""Pixels are means of so many painted ones, across and down."""


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
    light = bounced(room) * (corners(room, hits) * unshaded(room, hits))[..., None]
    for patch in room.patches:
        if patch.glow:
            light += falling(patch, room, hits)[..., None] * radiance(patch)
    return np.where(glow > 0, glow, albedo * light)


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
        glow[pane] = radiance(patch)
