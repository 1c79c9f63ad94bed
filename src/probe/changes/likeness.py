"""How much two sightings look like one thing seen twice: by colours, size and name."""

from __future__ import annotations

import math

from probe.changes.sighting import Sighting
from probe.manipulation.palette import agreement

COLOUR_WEIGHT, NAME_WEIGHT, SIZE_WEIGHT = 0.5, 0.35, 0.15
"""What each part of a likeness counts; perception may err in a name, and a thing that has turned
shows another size and other colours."""

_OTHER_SIZE = 6.0
_UNKNOWN, _OTHER_NAME = 0.5, -0.3


def likeness(one: Sighting, other: Sighting) -> float:
    """Up to 1."""
    colours = agreement(one.colours, other.colours)
    apart = abs(math.log(one.area / other.area)) / math.log(_OTHER_SIZE)
    size = 1 - min(1.0, apart)
    return COLOUR_WEIGHT * colours + NAME_WEIGHT * _names(one, other) + SIZE_WEIGHT * size


def _names(one: Sighting, other: Sighting) -> float:
    first, second = one.thing.words.name, other.thing.words.name
    if first is None or second is None:
        return _UNKNOWN
    return 1.0 if first == second else _OTHER_NAME
