"""Which thing a place in the picture means, and which of several lies furthest to a side."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import numpy as np

from probe.perception.things import Thing

NEAR_PX = 25
"""A place this close to a thing still means it."""

_NUMBER = r"(\d{1,6}(?:\.\d{1,6})?)"
_PLACE = re.compile(rf"(?:[(\[]\s*|\bat\s+){_NUMBER}\s*,\s*{_NUMBER}")

EXTREMES: dict[str, Callable[[Thing], int]] = {
    "left": lambda t: t.point_px[0],
    "right": lambda t: -t.point_px[0],
    "top": lambda t: t.point_px[1],
    "bottom": lambda t: -t.point_px[1],
    "large": lambda t: -int(t.mask.sum()),
    "small": lambda t: int(t.mask.sum()),
}
"""What is least for the thing that is meant, by what spatial words ask for."""


def place_in(description: str) -> tuple[float, float] | None:
    """(u, v) of a place that a description gives in pixels ("the thing at (512, 300)")."""
    place = _PLACE.search(description)
    return (float(place[1]), float(place[2])) if place else None


def thing_at(u: float, v: float, things: Sequence[Thing]) -> Thing | None:
    """The thing that shows at a place or at most NEAR_PX from it."""
    nearest, distance = None, NEAR_PX + 1.0
    for thing in things:
        rows, columns = np.nonzero(thing.mask)
        apart = float(np.hypot(columns - int(u), rows - int(v)).min())
        if apart < distance:
            nearest, distance = thing, apart
    return nearest if distance <= NEAR_PX else None
