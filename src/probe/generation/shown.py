"""What pictures show of lengths and heights beneath covers, for generators and verifiers."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import pairwise

from probe.perception.outline import box_of
from probe.tasks.truth import Silhouette
from probe.types import Array

LEVEL = 0.003
"""Metres by which the tops of the covers may differ, so that none tells what it stands over."""

SHOWN_LONGER = 1.12
"""Once the covers are gone, the box of what shows of each thing is this much longer than the next
one's: lengths that differ have to look different."""


def height_spread(silhouettes: Mapping[int, Silhouette], covers: Collection[int]) -> float:
    """Metres between the highest and the lowest top of some covers."""
    tops = [silhouettes[cover].top for cover in covers]
    return max(tops) - min(tops)


def least_step(labels: Array, order: Sequence[int]) -> float:
    """How many times as long each of some things looks as the next one, at least.

    Args:
        labels: Instance numbers of a picture without the covers, shape (h, w).
        order: Instances, the longest first.

    Returns:
        0 if one of them doesn't show.
    """
    sides = list(_longer_sides(labels, order))
    if min(sides) == 0:
        return 0.0
    return min(longer / shorter for longer, shorter in pairwise(sides))


def _longer_sides(labels: Array, order: Sequence[int]) -> Iterator[int]:
    """Longer sides in pixels of the boxes around what shows; 0 where nothing does."""
    for number in order:
        mask = labels == number
        if not mask.any():
            yield 0
            continue
        left, top, right, bottom = box_of(mask)
        yield max(right - left, bottom - top) + 1
