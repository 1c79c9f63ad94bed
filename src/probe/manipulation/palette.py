"""The colours of a thing beside those of all else in a picture. Knows no shapes.

Colours are compared by the Bhattacharyya coefficient of their histograms (Comaniciu, Ramesh and
Meer, "Kernel-based object tracking", PAMI 25(5), 2003).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PIL import Image
from scipy import ndimage

from probe.types import Array

_BINS = np.array([8, 32, 32])
_SMOOTH = (0.7, 0.9, 0.9)
_NEVER_SEEN = 1e-7


@dataclass(frozen=True, eq=False)
class Palette:
    """Colours of a thing and of the rest.

    Attributes:
        thing, rest: Histograms over luma and two chromas that add up to 1, shape (8, 32, 32).
    """

    thing: Array
    rest: Array

    @staticmethod
    def of(rgb: Array, mask: Array) -> Palette:
        """Of a picture, uint8, shape (h, w, 3), and the thing's pixels in it, bool, (h, w)."""
        bins = _bins(rgb)
        return Palette(_histogram(bins[mask]), _histogram(bins[~mask]))

    def likely(self, rgb: Array) -> Array:
        """Probability that a pixel shows the thing, by its colour alone, shape (h, w)."""
        bins = _bins(rgb)
        thing, rest = self.thing.ravel()[bins], self.rest.ravel()[bins]
        return thing / (thing + rest + _NEVER_SEEN)

    def alike(self, rgb: Array, mask: Array) -> float:
        """How much the colours under a mask are the thing's, 0 to 1."""
        return agreement(self.thing, histogram(rgb, mask))


def agreement(one: Array, other: Array) -> float:
    """Bhattacharyya coefficient of two histograms, 0 to 1."""
    return float(np.sqrt(one * other).sum())


def histogram(rgb: Array, mask: Array) -> Array:
    """Colours of a mask's pixels, over luma and two chromas, adding up to 1, shape (8, 32, 32)."""
    return _histogram(_bins(rgb[mask][None])[0])


def _bins(rgb: Array) -> Array:
    """Number of each pixel's bin, int, shape (h, w)."""
    cells = np.asarray(Image.fromarray(rgb).convert("YCbCr"), int) * _BINS // 256
    return (cells[..., 0] * _BINS[1] + cells[..., 1]) * _BINS[2] + cells[..., 2]


def _histogram(bins: Array) -> Array:
    counts = np.bincount(bins, minlength=int(_BINS.prod())).reshape(_BINS).astype(float)
    smooth: Array = ndimage.gaussian_filter(counts, _SMOOTH, mode="constant")
    return smooth / max(float(smooth.sum()), 1e-9)
