"""Boxes with rounded edges, one sheet a side. Knows no colour."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.assets.procedural.form.sheet import Sheet
from probe.types import Array

EDGE_STEPS = 4  # segments of a quarter turn around an edge, half of them on either side

Side = Literal["top", "bottom", "front", "back", "left", "right"]

# Outward, right and up directions of each side, as one sees it from outside.
SIDES: dict[Side, tuple[Array, Array, Array]] = {
    "top": (np.array([0, 0, 1]), np.array([1, 0, 0]), np.array([0, 1, 0])),
    "bottom": (np.array([0, 0, -1]), np.array([1, 0, 0]), np.array([0, -1, 0])),
    "front": (np.array([0, -1, 0]), np.array([1, 0, 0]), np.array([0, 0, 1])),
    "back": (np.array([0, 1, 0]), np.array([-1, 0, 0]), np.array([0, 0, 1])),
    "right": (np.array([1, 0, 0]), np.array([0, 1, 0]), np.array([0, 0, 1])),
    "left": (np.array([-1, 0, 0]), np.array([0, -1, 0]), np.array([0, 0, 1])),
}


def rounded_box(size: Array, radius: float) -> dict[Side, Sheet]:
    """Sides of a box that stands on z = 0 in the middle.

    Args:
        size: Along x, y, z in metres, shape (3,).
        radius: Of the edges and corners, metres; at most half the shortest side.
    """
    radius = min(radius, float(size.min()) / 2 * 0.999)
    return {name: _side(name, size / 2, radius) for name in SIDES}


def _side(name: Side, half: Array, radius: float) -> Sheet:
    out, right, up = SIDES[name]
    across = _stations(float(np.abs(right) @ half), radius)
    upward = _stations(float(np.abs(up) @ half), radius)
    direction = (
        out + np.tan(across[None, :, 1:]) * right + np.tan(upward[:, None, 1:]) * up
    )  # of the surface at each point, not yet a unit vector
    normals = direction / np.linalg.norm(direction, axis=-1, keepdims=True)
    core = (np.abs(out) @ half - radius) * out
    inner = core + across[None, :, :1] * right + upward[:, None, :1] * up
    points = inner + radius * normals
    width, height = 2 * float(np.abs(right) @ half), 2 * float(np.abs(up) @ half)
    uvs = np.stack([points @ right / width + 0.5, 0.5 - points @ up / height], axis=-1)
    rise = np.array([0, 0, half[2]])
    corner = out * half + rise - right * width / 2 + up * height / 2
    plane = np.stack([corner, right * width, -up * height])
    return Sheet(points + rise, normals, uvs, (width, height), plane)


def _stations(half: float, radius: float) -> Array:
    """Across a side: place on the inner box and tilt of the rounding, shape (n, 2)."""
    tilt = np.linspace(0, math.pi / 4, EDGE_STEPS // 2 + 1)
    inner = half - radius
    low = np.column_stack([np.full(len(tilt), -inner), -tilt[::-1]])
    high = np.column_stack([np.full(len(tilt), inner), tilt])
    return np.vstack([low, high])
