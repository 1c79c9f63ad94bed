"""What two depths may differ by and still show the same: one rule for exact and noisy cameras."""

from __future__ import annotations

import math

import numpy as np

from probe.types import Array, Frame

SPREAD = 3.0
"""Standard deviations of the noise that a depth may be away by without telling anything."""


def tolerance(least: float, *noises: float) -> float:
    """A threshold for exact depth, metres, widened by the noise of what it is used on."""
    return least + SPREAD * math.hypot(*noises)


def same_within(least: float, before: Frame, after: Frame) -> float:
    """A threshold for what two exact depths differ by, metres, widened by the frames' noise."""
    return tolerance(least, before.depth_noise, after.depth_noise)


def depth_change(before: Frame, after: Frame) -> Array:
    """How much further each pixel's point lies than before, metres, shape (h, w).

    Zero where one of the two cameras had no reading: nothing is known of a change there.
    """
    change: Array = after.depth - before.depth
    for frame in (before, after):
        if frame.measured is not None:
            change = np.where(frame.measured, change, np.zeros_like(change))
    return change
