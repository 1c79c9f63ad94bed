"""Which things of two looks are known by their place, whether outlines are exact or guessed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from probe.changes.places import unmoved
from probe.changes.sighting import Sighting
from probe.manipulation.looking import SAME
from probe.perception.depths import depth_change, same_within
from probe.types import Array, Frame

_STEADY = 0.9
_RECOLOURED = 40


class AtRest(NamedTuple):
    """What is where it was.

    Attributes:
        stayed: By the number of each earlier sighting that has stayed, the later one's; None if no
            later one shows it alone.
        known: Numbers of later sightings that show what was there before.
    """

    stayed: Mapping[int, int | None]
    known: frozenset[int]


def at_rest(
    before: Frame,
    after: Frame,
    earlier: Sequence[Sighting],
    later: Sequence[Sighting],
    *,
    guessed: bool,
) -> AtRest:
    """Find what is where it was.

    Args:
        before: The first frame.
        after: The second frame.
        earlier: What the first one shows.
        later: What the second one shows.
        guessed: Whether outlines are told from colours and depth. A thing may then be one piece in
            one look and two in the other, so that the pixels decide and not the pieces.
    """
    pairs = unmoved(before, after, earlier, later)
    if not guessed:
        return AtRest(pairs, frozenset(pairs.values()))
    same = _same(before, after)
    still = {number for number, one in enumerate(earlier) if _steady(same, one)}
    known = {number for number, one in enumerate(later) if _steady(same, one)}
    stayed = {number: pairs.get(number) for number in sorted(still | pairs.keys())}
    return AtRest(stayed, frozenset(known | set(pairs.values())))


def _steady(same: Array, sighting: Sighting) -> bool:
    return float(same[sighting.thing.mask].mean()) >= _STEADY


def _same(before: Frame, after: Frame) -> Array:
    """Pixels whose depth and colour are as they were, bool, shape (h, w)."""
    assert before.rgb is not None and after.rgb is not None
    near = np.abs(depth_change(before, after)) < same_within(SAME, before, after)
    apart = np.abs(after.rgb.astype(int) - before.rgb).max(axis=2)
    return near & (apart <= _RECOLOURED)
