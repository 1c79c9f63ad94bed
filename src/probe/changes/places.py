"""Which things are still where they were, by depth. Knows no looks and no names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from probe.changes.sighting import Sighting
from probe.manipulation.looking import SAME, still_there
from probe.types import Array, Frame

_NEARER = 0.001
_CONTRADICTED = 0.05
_COVERED = 0.6
_OVERLAPS, _LIES = 0.5, 0.3


def unmoved(
    before: Frame, after: Frame, earlier: Sequence[Sighting], later: Sequence[Sighting]
) -> Mapping[int, int]:
    """Pairs of things, one of each look, that nothing says have moved, by their numbers.

    A thing may show more or less of itself than before: what shows no longer must be hidden by
    something nearer, and what shows now must have been.
    """
    owner = np.full(after.depth.shape, -1)
    for number, sighting in enumerate(later):
        owner[sighting.thing.mask] = number
    pairs: dict[int, int] = {}
    for number, sighting in enumerate(earlier):
        mask = sighting.thing.mask
        owners = owner[mask]
        owners = owners[owners >= 0]
        if not owners.size:
            continue
        other = int(np.bincount(owners).argmax())
        now = later[other].thing.mask
        if other not in pairs.values() and _contradicted(before, after, mask, now) < _CONTRADICTED:
            pairs[number] = other
    return pairs


def covered(before: Frame, after: Frame, mask: Array) -> bool:
    """Whether something nearer to the camera has come over most of a mask's pixels."""
    return float(np.mean(after.depth[mask] < before.depth[mask] - _NEARER)) > _COVERED


def has_turned(before: Frame, after: Frame, was: Array, now: Array) -> bool:
    """Whether a thing whose middle has stayed lies otherwise: little is where or as high as it was.

    Args:
        before: The first frame.
        after: The second frame.
        was: What the first one shows of the thing.
        now: What the second one shows of it.
    """
    both = float(np.count_nonzero(was & now) / np.count_nonzero(was | now))
    return both < _OVERLAPS or still_there(before, after, was) < _LIES


def _contradicted(before: Frame, after: Frame, was: Array, now: Array) -> float:
    """Share of what a thing showed, or shows, that can't be if it stands as it stood."""
    nearer = before.depth - after.depth
    gone = was & ~now & (nearer <= _NEARER)
    come = now & ~was & (nearer >= -_NEARER)
    lifted = was & now & (np.abs(nearer) > SAME)
    earlier = np.count_nonzero(gone | lifted) / np.count_nonzero(was)
    return max(earlier, np.count_nonzero(come | lifted) / np.count_nonzero(now))
