"""Several depth pictures of one still table made into one; for cameras that err. Knows no arm.

A median over the pictures takes out what comes and goes, and a median over 3 x 3 pixels what is
left; both keep steps where they are (Tukey, "Exploratory Data Analysis", 1977).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.errors import ProbeError
from probe.types import Array

FRAMES = 9
"""Pictures that are fused where a camera is noisy: a third of a second at 30 pictures a second."""

_ROWS = 96
"""Rows in the middle of the picture from which the noise is told."""

_SD_OF_MAD = 1.4826


@dataclass(frozen=True, eq=False)
class FusedDepth:
    """What several depth pictures say together.

    Attributes:
        depth: Planar depth, metres, float32, shape (h, w); places without a reading have that of
            the nearest one that has it.
        noise: Standard deviation that is left at a pixel, metres, as measured; 0 of one picture.
        measured: Where there is a reading, bool, shape (h, w); None if it is everywhere.
    """

    depth: Array
    noise: float
    measured: Array | None


def fused(depths: Sequence[Array]) -> FusedDepth:
    """Fuse depth pictures that were taken one after another of a table on which nothing moved.

    Args:
        depths: Planar depth, metres, each of shape (h, w); 0 or NaN where there is no reading. A
            pixel counts as measured if at least half of the pictures have a reading of it.

    Raises:
        ProbeError: No pixel counts as measured.
    """
    stack = np.array(depths, dtype=np.float32)
    stack[~(stack > 0)] = np.nan
    present = np.isfinite(stack)
    if not present.any():
        raise ProbeError("The camera gave no depth at all. Is it covered?")
    measured = 2 * present.sum(axis=0) >= len(stack)
    if not measured.any():
        seen = int(present.any(axis=(1, 2)).sum())
        raise ProbeError(
            f"Only {seen} of the camera's {len(stack)} pictures have any depth, or each of another "
            "part. Is it covered, or too near?"
        )
    whole = bool(measured.all())
    depth = _together(stack, measured)
    return FusedDepth(depth, _noise(stack), None if whole else measured)


def _together(stack: Array, measured: Array) -> Array:
    """One picture of several, without holes."""
    if len(stack) == 1:
        return _filled(stack[0], measured)
    everywhere = np.isfinite(stack).all()
    middle = np.median(stack, axis=0) if everywhere else _median_of_present(stack)
    smooth: Array = ndimage.median_filter(_filled(middle, measured), 3)
    return smooth.astype(np.float32)


def _median_of_present(stack: Array) -> Array:
    """Lower median over what has a reading; NaN where nothing has."""
    ordered = np.sort(stack, axis=0)  # NaN comes last
    last = np.isfinite(stack).sum(axis=0) - 1
    return np.take_along_axis(ordered, np.maximum(last, 0)[None] // 2, axis=0)[0]


def _filled(depth: Array, measured: Array) -> Array:
    """A picture in which holes have the depth of the nearest measured pixel."""
    holes = ~(measured & np.isfinite(depth))
    if not holes.any() or holes.all():
        return depth
    nearest = ndimage.distance_transform_edt(holes, return_distances=False, return_indices=True)
    return depth[tuple(nearest)]


def _noise(stack: Array) -> float:
    """What noise the fused picture has, from how much both halves of the pictures differ."""
    if len(stack) < 2:
        return 0.0
    middle = stack.shape[1] // 2
    strip = stack[:, max(0, middle - _ROWS // 2) : middle + _ROWS // 2]
    parts = strip[::2], strip[1::2]
    there: list[Array] = [np.any(np.isfinite(part), axis=0) for part in parts]
    first, second = map(_together, parts, there)
    apart = (first - second)[there[0] & there[1]]
    if not apart.size:
        return 0.0
    # A half has sqrt(2) times the noise of the whole, their difference twice.
    return float(_SD_OF_MAD * np.median(np.abs(apart - np.median(apart))) / 2)
