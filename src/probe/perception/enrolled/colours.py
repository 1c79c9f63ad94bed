"""How much of which colours a surface shows, in CIELAB. Knows no shapes."""

from __future__ import annotations

import numpy as np
from scipy import ndimage

from probe.assets.colour.names import lab
from probe.types import Array

SHAPE = (8, 20, 20)
"""Bins over lightness and the two colour axes: 12.5 and twice 8 units of CIELAB wide."""

_LOW = np.array([0.0, -80.0, -80.0])
_WIDTH = np.array([12.5, 8.0, 8.0])
_SMOOTH = (0.8, 0.6, 0.6)
_MOST_PIXELS = 4000


def colours_of(pixels: Array) -> Array:
    """Histogram of pixels' colours that adds up to 1.

    Args:
        pixels: sRGB uint8, shape (n, 3), n > 0.

    Returns:
        Shape SHAPE. It is smoothed, so that a little more light or shade changes it little.
    """
    few = pixels[:: max(1, len(pixels) // _MOST_PIXELS)]
    index = ((lab(few) - _LOW) / _WIDTH).astype(int)
    index = np.clip(index, 0, np.array(SHAPE) - 1)
    flat = np.ravel_multi_index(tuple(index.T), SHAPE)
    counts = np.bincount(flat, minlength=int(np.prod(SHAPE))).reshape(SHAPE).astype(float)
    smooth: Array = ndimage.gaussian_filter(counts, _SMOOTH, mode="nearest")
    return smooth / smooth.sum()
