"""Main colours of an object in the words of people, who name a hue where there is a little of one.

The names of single pixels in ``colours.py`` decide what suites and perception say and stay as they
are; these only draft what a user's own objects are called.
"""

from __future__ import annotations

import numpy as np

from probe.assets.colour.names import EXAMPLES, Colour, lab
from probe.types import Array

LIGHTNESS = 0.6
"""Weight of lightness against hue and chroma: a dull green in shadow is green, not gray."""

SECOND_SHARE = 0.3

_DULL: dict[Colour, tuple[tuple[int, int, int], ...]] = {
    "black": ((60, 60, 62),),
    "orange": ((210, 75, 30),),
    "yellow": ((205, 220, 80),),
    "green": ((150, 190, 60), (95, 105, 75), (190, 205, 130), (60, 70, 50)),
    "blue": ((100, 105, 140), (60, 68, 90), (40, 44, 62), (90, 100, 120)),
    "purple": ((72, 28, 45),),
    "brown": ((95, 80, 65), (130, 110, 90)),
    "beige": ((205, 195, 178), (150, 130, 95)),
}
"""sRGB of what people call so though it is dull or between two; beside the plain examples.

Chosen by eye on the 165 scans, on which the first colour agrees with the annotated first one 146
times, with one of the annotated ones 158 times; without, 135 and 144 times."""


def said_colours(pixels: Array) -> tuple[Colour, ...]:
    """The main colour of pixels, sRGB uint8, shape (n, 3), and the second from a share of 0.3 on.

    Args:
        pixels: Spread evenly over the object's surface, not over its texture.
    """
    named = [
        (name, rgb) for table in (EXAMPLES, _DULL) for name, group in table.items() for rgb in group
    ]
    scale = np.array([LIGHTNESS, 1.0, 1.0])
    examples = lab(np.array([rgb for _, rgb in named])) * scale
    apart = np.linalg.norm((lab(pixels) * scale)[:, None] - examples[None], axis=2)
    found = np.array([name for name, _ in named])[apart.argmin(axis=1)]
    shares = {name: float((found == name).mean()) for name in EXAMPLES}
    first, second = sorted(EXAMPLES, key=lambda name: -shares[name])[:2]
    return (first, second) if shares[second] >= SECOND_SHARE else (first,)
