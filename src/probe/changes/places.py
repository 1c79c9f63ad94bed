"""Which things are still where they were, by depth. Knows no looks and no names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy import ndimage

from probe.changes.sighting import Sighting
from probe.manipulation.looking import SAME, still_there
from probe.perception.depths import depth_change, same_within
from probe.types import Array, Frame

_NEARER = 0.001
_CONTRADICTED = 0.05
_COVERED = 0.6
_OVERLAPS, _LIES = 0.5, 0.3
_BESIDE = 0.02
_SAME_AREA = 0.8
_EXPLAINED = 0.8


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
    nearer = same_within(_NEARER, before, after)
    return float(np.mean(after.depth[mask] < before.depth[mask] - nearer)) > _COVERED


def has_turned(before: Frame, after: Frame, was: Array, now: Array) -> bool:
    """Whether a thing whose middle has stayed may lie otherwise: little is as and where it was.

    Of one that shows much more or less of itself than before, what shows both times tells.

    Args:
        before: The first frame.
        after: The second frame.
        was: What the first one shows of the thing.
        now: What the second one shows of it.
    """
    both, sizes = np.count_nonzero(was & now), (np.count_nonzero(was), np.count_nonzero(now))
    if min(sizes) < _SAME_AREA * max(sizes):
        return bool(both < _OVERLAPS * min(sizes)) or still_there(before, after, was & now) < _LIES
    share = both / np.count_nonzero(was | now)
    return bool(share < _OVERLAPS) or still_there(before, after, was) < _LIES


def hidden_otherwise(before: Frame, after: Frame, was: Array, now: Array, common: float) -> bool:
    """Whether a thing only shows another part of itself: what hides it has gone, or has come.

    Nearly all that shows no longer is behind something nearer now, and nearly all that has come to
    light was.

    Args:
        before: The first frame.
        after: The second frame.
        was: What the first one shows of the thing.
        now: What the second one shows of it.
        common: Share of the smaller of these that both must show.
    """
    nearer, hiding = -depth_change(before, after), same_within(_NEARER, before, after)
    explained = np.where(was, nearer > hiding, nearer < -hiding)[was ^ now]
    both, least = np.count_nonzero(was & now), min(np.count_nonzero(was), np.count_nonzero(now))
    return bool(explained.size and explained.mean() >= _EXPLAINED and both >= common * least)


def is_cut_off(mask: Array) -> bool:
    """Whether a mask reaches the picture's edge."""
    return bool(mask[[0, -1]].any() or mask[:, [0, -1]].any())


def about_there(before: Frame, was: Array, now: Array) -> bool:
    """Whether a mask lies on or beside most of where an earlier one was."""
    reach = round(_BESIDE / _pixel(before, was))
    near = ndimage.distance_transform_edt(~now) <= reach
    return float(near[was].mean()) > _OVERLAPS


def least_shift(before: Frame, was: Array, now: Array) -> Array:
    """How far a thing went at the least that shows more or less of itself, metres, shape (3,).

    Along each edge of the picture, the smaller extent has to come to lie within the larger one.

    Args:
        before: The first frame.
        was: What the first frame shows of the thing.
        now: What the second one shows of it.
    """
    across = np.zeros(3)
    for axis in (0, 1):
        first, last = np.subtract(_extent(now, axis), _extent(was, axis)).tolist()
        low, high = min(first, last), max(first, last)
        across[axis] = max(low, 0) + min(high, 0)
    return before.camera.world_from_camera.rotation @ (across * _pixel(before, was))


def _extent(mask: Array, axis: int) -> tuple[int, int]:
    """First and last column (axis 0) or row (axis 1) of a mask."""
    shown = np.flatnonzero(mask.any(axis=axis))
    return int(shown[0]), int(shown[-1])


def _pixel(frame: Frame, mask: Array) -> float:
    """Metres across a pixel, where a mask is."""
    return float(np.median(frame.depth[mask])) / frame.camera.focal_px


def _contradicted(before: Frame, after: Frame, was: Array, now: Array) -> float:
    """Share of what a thing showed, or shows, that can't be if it stands as it stood."""
    nearer = -depth_change(before, after)
    hiding = same_within(_NEARER, before, after)
    gone = was & ~now & (nearer <= hiding)
    come = now & ~was & (nearer >= -hiding)
    lifted = was & now & (np.abs(nearer) > same_within(SAME, before, after))
    earlier = np.count_nonzero(gone | lifted) / np.count_nonzero(was)
    return max(earlier, np.count_nonzero(come | lifted) / np.count_nonzero(now))
