"""Whether what shows of a thing lets one tell what it is. Knows no words.

Half of a thing tells what it is. With less, a piece that is about as wide as the whole thing does
(a third of a toothbrush), and a sliver along its edge doesn't (the rim of a cup). Colours don't
count: in the catalogue the main colour of an object is that of 80 other categories on average.
"""

from __future__ import annotations

import numpy as np

from probe.perception.outline import deepest_inside
from probe.types import Array, Vector3

SEEN_SHARE = 0.30
"""Visible share from which on a thing may be named."""

SEEN_PX = 400
"""Visible pixels from which on a thing may be named."""

PLAIN_SHARE = 0.50
"""Visible share from which on its width doesn't matter."""

WIDTH_SHOWN = 0.6
"""Width of what shows, compared with that of the whole thing, from which on a thing is named."""


def identifies(mask: Array, share: float, size: Vector3) -> bool:
    """Whether a thing can be named.

    Args:
        mask: What shows of it, bool, shape (h, w).
        share: Which part of it that is, 0 to 1.
        size: Its extents in metres.
    """
    if share < SEEN_SHARE or np.count_nonzero(mask) < SEEN_PX:
        return False
    return share >= PLAIN_SHARE or width_shown(mask, share, size) >= WIDTH_SHOWN


def width_shown(mask: Array, share: float, size: Vector3) -> float:
    """Width of what shows over that of the whole thing, both as the widest disc that fits in.

    The whole thing is taken for an ellipse of the area that the share lets one expect, with the
    proportions of its two longest extents; one that stands upright is rounder, which errs on the
    side of a name.
    """
    _, middle, longest = sorted(size)
    area = np.count_nonzero(mask) / share
    whole = np.sqrt(area * middle / longest / np.pi)
    return float(deepest_inside(mask)[1] / whole)
