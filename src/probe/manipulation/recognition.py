"""Finds a thing again by its colours where its shape isn't enough. Knows no names."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy import ndimage

from probe.manipulation.looking import NOWHERE, Found, above_table, changed, tracked
from probe.manipulation.palette import Palette
from probe.manipulation.terrain import lifted
from probe.station.colours import coloured, in_colour
from probe.station.station import Station
from probe.types import Array, Frame

_CERTAIN = 0.9
_PLAUSIBLE, _PLAUSIBLE_PX = 0.3, 5
_ROUGHLY = 0.35
_SHAPE_BONUS = (0.08, 0.05)
_FREE_SIZE, _SIZE_COST, _OTHER_SIZE = 0.3, 0.25, 4.0
_LEAST = 0.6
_BEYOND, _BEYOND_COST = 0.05, 0.25
_LIKELIER, _WINDOW_PX = (0.5, 0.75), 7
_RECOLOURED = 30
_EDGE = 0.006
_WHOLE = 0.3
_PATCHES = 3
_FEWEST_PX = 50


def found_again(
    station: Station, before: Frame, after: Frame, mask: Array, way: Array = NOWHERE
) -> tuple[Frame, Found | None]:
    """Find a thing again after a motion; a look in colour is taken only if its shape won't do.

    Args:
        station: Looks.
        before: Where the mask is known; with colours, or a painter of them.
        after: The table as it is now.
        mask: bool, shape (h, w), not empty.
        way: A straight line from where it was, on which it may have stopped anywhere, metres,
            shape (3,).

    Returns:
        The newest look at the table, and the thing in it; None if nothing there looks like it.
    """
    found = tracked(before, after, mask, way)
    if found is None or found.merit < _CERTAIN:
        after = in_colour(station, after)
        found = recognised(coloured(before), after, mask, way, found)
    return after, found


def recognised(
    before: Frame, after: Frame, mask: Array, way: Array, found: Found | None
) -> Found | None:
    """Find a thing again that may have tipped onto another side or rolled away.

    Where its shape could be, with and without regard to colours, and patches of its colours are
    compared with what it looked like.

    Args:
        before: Where the mask is known; with colours.
        after: Where it is looked for; with colours.
        mask: bool, shape (h, w), not empty.
        way: A straight line from where it was, on which it may have stopped anywhere, metres,
            shape (3,).
        found: Where its shape alone could be.

    Returns:
        None if no place looks like it.
    """
    assert before.rgb is not None and after.rgb is not None
    palette = Palette.of(before.rgb, mask)
    likely = palette.likely(after.rgb)
    plausible = ndimage.uniform_filter(likely, _PLAUSIBLE_PX) > _PLAUSIBLE
    likely *= _possible(before, after, mask)
    shapes = found, tracked(before, after, mask, way, plausible, _ROUGHLY)
    patches = [_moved(before, after, mask, patch) for patch in _patches(after, likely)]
    options = [
        (option, bonus)
        for option, bonus in (*zip(shapes, _SHAPE_BONUS, strict=True), *((p, 0.0) for p in patches))
        if option is not None and np.count_nonzero(option.mask) >= _FEWEST_PX
    ]
    explained = np.array([likely[option.mask].sum() for option, _ in options])
    whole = _WHOLE * explained / max(1.0, explained.max(initial=0.0))
    best, merit = None, _LEAST
    for (option, bonus), extra in zip(options, whole, strict=True):
        looks = palette.alike(after.rgb, option.mask) + bonus + extra
        looks -= _misfit(option.mask, mask) + _beyond(option.shift, way)
        if looks > merit:
            best, merit = option, looks
    return best


def _misfit(one: Array, other: Array) -> float:
    """Cost of being much larger or smaller."""
    apart = abs(np.log(np.count_nonzero(one) / np.count_nonzero(other))) / np.log(_OTHER_SIZE)
    return _SIZE_COST * max(0.0, min(1.0, float(apart)) - _FREE_SIZE)


def _beyond(shift: Array, way: Array) -> float:
    """Cost of being further along than it can have been taken; few things roll on."""
    length = float(np.linalg.norm(way))
    ahead = float(shift @ way) / max(length, 1e-6) - length
    return _BEYOND_COST if ahead > _BEYOND else 0.0


def _possible(before: Frame, after: Frame, mask: Array) -> Array:
    """What has changed in depth or colour and is above the table, bool, shape (h, w)."""
    assert before.rgb is not None and after.rgb is not None
    recoloured = np.abs(after.rgb.astype(int) - before.rgb).max(axis=2) > _RECOLOURED
    return (changed(before, after, mask) | recoloured) & above_table(after)


def _patches(after: Frame, likely: Array) -> Iterator[Array]:
    """Smooth pieces that have the thing's colours, the likeliest few."""
    smooth = np.abs(np.asarray(np.gradient(after.depth))).max(axis=0) < _EDGE
    for least in _LIKELIER:
        share = ndimage.uniform_filter(likely - least, _WINDOW_PX)
        pieces = ndimage.binary_opening((share > 0) & smooth, iterations=2)
        numbers, count = ndimage.label(pieces)
        sums = ndimage.sum(np.maximum(likely - 0.4, 0), numbers, np.arange(1, count + 1))
        for number in np.argsort(-sums, kind="stable")[:_PATCHES] + 1:
            whole = ndimage.binary_dilation(numbers == number, iterations=3) & (likely > 0)
            yield ndimage.binary_fill_holes(whole)


def _moved(before: Frame, after: Frame, mask: Array, patch: Array) -> Found:
    shift = lifted(after, patch).mean(axis=0) - lifted(before, mask).mean(axis=0)
    return Found(patch, shift, 0.0)
