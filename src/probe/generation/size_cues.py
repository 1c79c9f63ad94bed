"""By how much more of the larger of two marked things shows, in three ways: Size's cues."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import ndimage

from probe.perception.outline import box_of, window_of
from probe.types import Array


class SizeCues(NamedTuple):
    """What the larger thing has over the smaller one; negative where it lags.

    Attributes:
        area: Natural logarithm of the ratio of the pixels that show.
        length: The same of the diagonals of the boxes around these.
        outline: Difference of the shares of their outlines along which other things lie.
    """

    area: float
    length: float
    outline: float


Windows = Sequence[tuple[float, float]]
"""Least and most of leads, whichever thing leads."""

WINDOWS: Windows = ((math.log(1.05), math.log(2.0)), (math.log(1.05), math.log(1.5)), (0.01, 0.3))
"""Of SizeCues: where amounts differ, they tell which is larger."""

_BAND_PX = 4


@dataclass(frozen=True)
class VisiblePatch:
    """What shows of a thing.

    Attributes:
        area_px: Its pixels.
        diagonal_px: Of the box around them.
        overlapped: Share of the band around them that belongs to other things, not to the table.
    """

    area_px: int
    diagonal_px: float
    overlapped: float

    @classmethod
    def of(cls, labels: Array, number: int) -> VisiblePatch:
        """What shows of an instance that is in a picture's labels, shape (h, w)."""
        labels = labels[window_of(labels == number, _BAND_PX)]
        mine = labels == number
        band = labels[ndimage.binary_dilation(mine, iterations=_BAND_PX) & ~mine]
        left, top, right, bottom = box_of(mine)
        diagonal = math.hypot(bottom - top + 1, right - left + 1)
        return cls(int(np.count_nonzero(mine)), diagonal, float((band != 0).mean()))


def leads_of(larger: VisiblePatch, smaller: VisiblePatch) -> SizeCues:
    """What the larger thing has over the smaller one."""
    return SizeCues(
        math.log(larger.area_px / smaller.area_px),
        math.log(larger.diagonal_px / smaller.diagonal_px),
        larger.overlapped - smaller.overlapped,
    )


def are_within(leads: Sequence[float], signs: Sequence[int], windows: Windows) -> bool:
    """Whether each is within its window, on the side that its sign, 1 or -1, says."""
    return all(
        least <= sign * lead <= most
        for sign, lead, (least, most) in zip(signs, leads, windows, strict=True)
    )
