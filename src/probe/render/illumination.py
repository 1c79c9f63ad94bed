"""How a scene is lit, as a value: a panorama of radiance and a sun. Knows no engine, no files.

Every renderer takes light in this form. Radiance is scaled so that 1 from all sides shows a
surface in its own colour.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.types import Array, Vector3


@dataclass(frozen=True)
class Sun:
    """Light from one direction; it casts shadows.

    Attributes:
        towards: Unit vector from the table to the sun, world frame.
        irradiance: Red, green and blue on a surface that faces the sun, divided by pi: what it
            adds to the picture of a white one.
        size: How wide it is beside a usual one: what makes its shadows soft.
        distance: Of a window or lamp, metres: its shadows fade with what lies between the thing
            and its shadow, and it lights near things more. None for one that is far away.
    """

    towards: Vector3
    irradiance: Vector3
    size: float = 1.0
    distance: float | None = None


@dataclass(frozen=True, eq=False)
class Illumination:
    """All light that falls on a scene.

    Attributes:
        radiance: From far away, linear RGB, float16, shape (h, w, 3) with w = 2 h: the top row is
            overhead, the middle column lies towards +y, columns to the right of it towards +x.
        sun: What was too bright and too small for that, or None.
        backdrop: What is seen behind the table, a panorama as well; None for an even grey.
    """

    radiance: Array
    sun: Sun | None = None
    backdrop: Array | None = None


AMBIENT = Illumination(np.ones((1, 2, 3), np.float16))
"""Even light from everywhere, no cast shadow.

The flat grey dome (0.85 at strength 0.8) at the exposure that shows a white card as white.
"""


def directions(height: int) -> Array:
    """Unit vectors, world frame, through a panorama's pixels; shape (height, 2 height, 3)."""
    up = np.pi * (0.5 - (np.arange(height) + 0.5) / height)[:, None]
    round_: Array = (np.pi * ((np.arange(2 * height) + 0.5) / height - 1))[None, :]
    flat = np.cos(up)
    parts = [flat * np.sin(round_), flat * np.cos(round_), np.sin(up) + 0 * round_]
    return np.stack(parts, axis=-1)


def solid_angles(height: int) -> Array:
    """Steradians of each of a panorama's pixels by row, shape (height, 1)."""
    edges = np.sin(np.pi * (0.5 - np.arange(height + 1) / height))
    return (np.pi / height * -np.diff(edges))[:, None]
