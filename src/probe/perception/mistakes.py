"""What a detector gets wrong, done to things: cut in two, joined, made up. Knows no luck."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.ndimage import binary_dilation

from probe.perception.things import Thing, Words
from probe.types import Array

_SMALLEST_PART = 50
_REACH_PX = 3
_TRIES = 30
_RADII_PX = (14, 32)


def cut_in_two(thing: Thing, angle: float) -> tuple[Thing, ...]:
    """Its two halves, cut through the middle at an angle in radians; whole if it is too small."""
    rows, columns = np.nonzero(thing.mask)
    along = (columns - columns.mean()) * np.cos(angle) + (rows - rows.mean()) * np.sin(angle)
    sides = [along >= 0, along < 0]
    if min(int(side.sum()) for side in sides) < _SMALLEST_PART:
        return (thing,)
    parts: list[Thing] = []
    for side in sides:
        mask = np.zeros_like(thing.mask)
        mask[rows[side], columns[side]] = True
        parts.append(Thing.of(mask, thing.words))
    return tuple(parts)


def neighbour_of(thing: Thing, others: Sequence[Thing]) -> int | None:
    """Which of the others it meets along the longest outline; None if it meets none."""
    around = np.asarray(binary_dilation(thing.mask, iterations=_REACH_PX)) & ~thing.mask
    shared = [int(np.count_nonzero(around & other.mask)) for other in others]
    return int(np.argmax(shared)) if any(shared) else None


def united(one: Thing, other: Thing) -> Thing:
    """Both as one thing, told as the larger."""
    larger = one if np.count_nonzero(one.mask) > np.count_nonzero(other.mask) else other
    return Thing.of(one.mask | other.mask, larger.words)


def invented(taken: Array, words: Words, rng: np.random.Generator) -> Thing | None:
    """An ellipse of bare table as a thing; None if no place for it was found.

    Args:
        taken: Pixels where things are, bool, shape (h, w).
        words: What it is called.
        rng: Says where it is and of what size.
    """
    for _ in range(_TRIES):
        across, down = rng.integers(*_RADII_PX, size=2).tolist()
        rows, columns = np.mgrid[-down : down + 1, -across : across + 1]
        ellipse: Array = np.hypot(columns / across, rows / down) <= 1
        top, left = rng.integers(0, np.array(taken.shape) - ellipse.shape + 1).tolist()
        place = slice(top, top + 2 * down + 1), slice(left, left + 2 * across + 1)
        if not (taken[place] & ellipse).any():
            mask = np.zeros_like(taken)
            mask[place] = ellipse
            return Thing.of(mask, words)
    return None
