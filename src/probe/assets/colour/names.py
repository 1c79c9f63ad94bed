"""Everyday names of the colours of many pixels, of a picture or a texture. Knows no objects."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.types import Array

Colour = Literal[
    "white", "gray", "black", "red", "orange", "yellow", "green", "teal", "blue", "purple",
    "pink", "brown", "beige",
]  # fmt: skip

# sRGB of plain things in soft light, lit and shaded; chosen by eye.
EXAMPLES: dict[Colour, tuple[tuple[int, int, int], ...]] = {
    "white": ((245, 245, 242), (215, 214, 210)),
    "gray": ((165, 165, 165), (125, 125, 125), (85, 85, 86)),
    "black": ((45, 45, 47), (20, 20, 22)),
    "red": ((205, 45, 45), (150, 25, 28), (95, 18, 20)),
    "orange": ((235, 125, 35), (190, 90, 25)),
    "yellow": ((245, 215, 60), (195, 165, 35)),
    "green": ((60, 140, 65), (130, 185, 80), (30, 75, 40)),
    "teal": ((30, 140, 140), (100, 185, 180), (20, 85, 90)),
    "blue": ((40, 85, 170), (120, 170, 220), (22, 40, 90)),
    "purple": ((110, 60, 140), (165, 130, 190), (60, 30, 80)),
    "pink": ((235, 150, 170), (210, 90, 130)),
    "brown": ((115, 75, 45), (75, 45, 28), (150, 105, 70)),
    "beige": ((220, 200, 165), (190, 165, 125)),
}

_SECOND_SHARE = 0.3
_MOST_PIXELS = 4000

# Linear sRGB to CIE XYZ under D65 (IEC 61966-2-1), divided by the white point.
_XYZ_FROM_RGB = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
) / np.array([[0.95047], [1.0], [1.08883]])


def lab(rgb: Array) -> Array:
    """CIELAB (D65) of sRGB colours, uint8 or 0-255, shape (n, 3).

    IEC 61966-2-1 for the transfer function, CIE 15:2004 for L*a*b*.
    """
    encoded = np.asarray(rgb, dtype=float) / 255
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    xyz = linear @ _XYZ_FROM_RGB.T
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    x, y, z = f.T
    return np.column_stack([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def main_colours(pixels: Array) -> tuple[Colour, ...]:
    """The most frequent colour of pixels, sRGB uint8, shape (n, 3), and the second if it matters.

    Each pixel gets the name of the nearest example in CIELAB.
    """
    found = nearest_colours(pixels[:: max(1, len(pixels) // _MOST_PIXELS)])
    shares = {name: float((found == name).mean()) for name in EXAMPLES}
    first, second = sorted(EXAMPLES, key=lambda name: -shares[name])[:2]
    return (first, second) if shares[second] >= _SECOND_SHARE else (first,)


def nearest_colours(pixels: Array) -> Array:
    """Name of the nearest example in CIELAB of each pixel, sRGB uint8, shape (n, 3)."""
    names = np.array([name for name, examples in EXAMPLES.items() for _ in examples])
    examples = lab(np.array([rgb for group in EXAMPLES.values() for rgb in group]))
    apart = np.linalg.norm(lab(pixels)[:, None] - examples[None], axis=2)
    return names[apart.argmin(axis=1)]
