"""What can be said of a thing by the colours and the outline of its pixels. Knows no objects."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.colour.names import EXAMPLES, Colour, main_colours, nearest_colours
from probe.perception.outline import shape_word
from probe.perception.tokens import colour_match, is_colour, tokens
from probe.types import Array, Frame

_BELIED_SHARE = 0.15
_MOST_PIXELS = 2000
_SHADES = {
    "white": ("gray", "beige"),
    "beige": ("gray", "brown"),
    "silver": ("black", "beige"),
    "gold": ("brown", "orange", "beige"),
    "tan": ("gray",),
    "gray": ("white",),
    "purple": ("brown",),
    "dark": ("black",),
}
"""How light and shade change colours beside what people mix up."""


def look_of(mask: Array, frame: Frame) -> tuple[tuple[Colour, ...], str]:
    """Main colours of a mask's pixels, and a phrase on them and its shape.

    Args:
        mask: Visible pixels, bool, shape (h, w).
        frame: Must have colours.
    """
    assert frame.rgb is not None
    colours = main_colours(frame.rgb[mask])
    rows, columns = np.nonzero(mask)
    centres = np.column_stack([columns, rows]) + 0.5
    heights = frame.camera.lift(centres, frame.depth[rows, columns])[:, 2]
    return colours, f"{' and '.join(colours)}, what shows is {shape_word(mask, heights)}"


def belies(pixels: Array, told: Sequence[str]) -> tuple[Colour, ...]:
    """Main colours of pixels that hardly show any of the colours that are told; else nothing.

    Args:
        pixels: sRGB uint8, shape (n, 3).
        told: What the thing's colours are said to be.
    """
    words = {word for colour in told for word in tokens(colour)}
    if not any(map(is_colour, words)):
        return ()
    agreeing = [name for name in EXAMPLES if any(may_look(word, name) for word in words)]
    found = nearest_colours(pixels[:: max(1, len(pixels) // _MOST_PIXELS)])
    share = float(np.isin(found, agreeing).mean())
    return main_colours(pixels) if share < _BELIED_SHARE else ()


def may_look(told: str, seen: str) -> bool:
    """Whether a thing of one colour may look like another one, in light or in shade."""
    return colour_match(told, seen) > 0 or seen in _SHADES.get(told, ())
