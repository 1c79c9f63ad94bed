"""Marks a thing in a picture. Pixels in, pixels out."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import binary_dilation

from probe.perception.things import Thing
from probe.types import Array

_INK = np.array([255, 40, 200], dtype=np.uint8)
_RIM = np.array([255, 255, 255], dtype=np.uint8)

_INK_PX, _RIM_PX = 3, 2
_MARGIN = _INK_PX + _RIM_PX


def outlined(picture: Array, thing: Thing, width: int = 1) -> Array:
    """A copy of a picture, uint8 (h, w, 3), with an outline around a thing's visible pixels.

    Args:
        picture: Where it shows.
        thing: What is outlined.
        width: Times the usual width, for a picture that is shown smaller than it is.
    """
    margin = width * _MARGIN
    left, top, right, bottom = thing.box_px
    around = (
        slice(max(top - margin, 0), bottom + margin + 1),
        slice(max(left - margin, 0), right + margin + 1),
    )
    mask = thing.mask[around]
    inner = np.asarray(binary_dilation(mask, iterations=width * _INK_PX))
    outer = np.asarray(binary_dilation(inner, iterations=width * _RIM_PX))
    marked = picture.copy()
    marked[around][outer & ~inner] = _RIM
    marked[around][inner & ~mask] = _INK
    return marked
