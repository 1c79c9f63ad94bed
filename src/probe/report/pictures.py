"""Depth and labels as image files that both people and programs can read."""

from __future__ import annotations

import colorsys

import numpy as np
from PIL import Image

from probe.types import Array

DEPTH_UNIT = 1e-4
"""Metres per step of a 16-bit depth image; 0 means no depth."""

_GOLDEN_ANGLE = 0.381966
_COLOURS = 256


def depth_image(depth: Array) -> Image.Image:
    """Planar depth in metres, shape (h, w), as 16-bit grey in steps of 0.1 mm."""
    steps = np.clip(np.nan_to_num(depth) / DEPTH_UNIT, 0, np.iinfo(np.uint16).max)
    return Image.fromarray(np.round(steps).astype(np.uint16))


def label_image(labels: Array) -> Image.Image:
    """Instance numbers below 256, shape (h, w), as a palette image: values stay, colours show."""
    image = Image.fromarray(labels.astype(np.uint8)).convert("P")
    image.putpalette([channel for label in range(_COLOURS) for channel in label_colour(label)])
    return image


def label_colour(label: int) -> tuple[int, int, int]:
    """A colour for an instance, far from its neighbours'; black for 0."""
    if label == 0:
        return (0, 0, 0)
    red, green, blue = colorsys.hsv_to_rgb(label * _GOLDEN_ANGLE % 1, 0.65, 0.95)
    return round(red * 255), round(green * 255), round(blue * 255)
