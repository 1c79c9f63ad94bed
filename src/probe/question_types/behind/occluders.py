"""What can stand in front of something and hide it from the front camera. Geometry alone."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import Cover, Footprint
from probe.generation.sizes import extent_of
from probe.scene.turns import in_turn
from probe.types import Quaternion, quaternion_of

TALLEST, SHORTEST = 0.24, 0.12
"""Metres; the hand lifts what stands so high over everything else on the table."""

WIDEST_GRIP = 0.115
"""Metres; narrow side from which on a standing thing can't be gripped from above."""

THINNEST = 0.04
"""Metres; what is thinner falls over when it is stood on end."""

_BOX, _SOLID = 0.98, 0.72
"""Share of its bounding box that a thing's hull fills: only boxes stand on end, and what is slim in
places, as a goblet is, hides little."""

_WIDER = 1.05

NEEDS_OCCLUDER = (
    f"a thing {100 * SHORTEST:g} to {100 * TALLEST:g} cm high, or a box that is when it is stood "
    f"on end, with a side of {100 * THINNEST:g} to {100 * WIDEST_GRIP:g} cm to grip, wider than "
    "what it hides"
)


def draw_occluder(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
) -> Cover | None:
    """Draw something that, standing, may hide each of these behind it; None if there is none."""
    widest = max(item.width for item in items)
    for spec in in_turn(specs, library.leads, rng):
        standing = _standing(library, spec)
        if standing and standing.extent[0] >= _WIDER * widest:
            return standing
    return None


def _standing(library: Library, spec: ObjectSpec) -> Cover | None:
    """How a thing stands, its wide side along x; None if it is no occluder."""
    thin, middle, tall = sorted(spec.size)
    upright = spec.size[2] >= SHORTEST
    if not upright and (spec.hollow or thin < THINNEST or not SHORTEST <= tall <= TALLEST):
        return None
    narrow, wide, height = (thin, middle, tall) if not upright else _sides(spec)
    if not (THINNEST <= narrow <= WIDEST_GRIP and height <= TALLEST):
        return None
    filled = extent_of(library, spec.id).volume / math.prod(spec.size)
    if filled < (_SOLID if upright else _BOX):
        return None
    wxyz = _on_end(spec)
    if upright:
        wxyz = (1.0, 0.0, 0.0, 0.0) if spec.size[0] >= spec.size[1] else _quarter_turn()
    return Cover(spec, wxyz, (wide, narrow, height), (0.0, 0.0), 0.0, 0.0)


def _sides(spec: ObjectSpec) -> tuple[float, float, float]:
    """Narrow and wide side and height of a thing that stands as it is."""
    x, y, z = spec.size
    return min(x, y), max(x, y), z


def _quarter_turn() -> Quaternion:
    half = math.sqrt(0.5)
    return (half, 0.0, 0.0, half)


def _on_end(spec: ObjectSpec) -> Quaternion:
    """The turn that brings the longest side up and the middle one along x."""
    axes = np.argsort(spec.size)
    rotation = np.zeros((3, 3))
    rotation[1, axes[0]] = rotation[0, axes[1]] = rotation[2, axes[2]] = 1.0
    if np.linalg.det(rotation) < 0:
        rotation[1] *= -1
    w, x, y, z = (float(part) for part in quaternion_of(rotation))
    return w, x, y, z
