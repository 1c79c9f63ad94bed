"""Which parts of the picture are full of things and which are empty. Masks alone."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from probe.perception.scene_graph import Region
from probe.perception.things import Thing

CLUTTERED = 0.5
"""Share of a part that things cover from which on it counts as cluttered."""

CLEAR = 0.05
"""Share up to which it counts as clear."""

_ROWS: tuple[tuple[Region, Region, Region], ...] = (
    ("top left", "top centre", "top right"),
    ("middle left", "middle centre", "middle right"),
    ("bottom left", "bottom centre", "bottom right"),
)


class Regions(NamedTuple):
    """Names of parts of the picture, from top left to bottom right."""

    cluttered: list[Region]
    clear: list[Region]


def regions(things: Sequence[Thing], shape: tuple[int, int]) -> Regions:
    """Cluttered and clear parts of a picture of that shape (h, w), cut three by three."""
    taken = np.zeros(shape, dtype=bool)
    for thing in things:
        taken |= thing.mask
    found = Regions([], [])
    for row, band in zip(_ROWS, np.array_split(taken, 3, axis=0), strict=True):
        for name, part in zip(row, np.array_split(band, 3, axis=1), strict=True):
            share = float(part.mean())
            if share >= CLUTTERED:
                found.cluttered.append(name)
            elif share <= CLEAR:
                found.clear.append(name)
    return found
