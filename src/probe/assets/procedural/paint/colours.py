"""Names of colours and what they look like on things. Knows no surfaces."""

from __future__ import annotations

import re

import numpy as np

from probe.errors import UnknownName
from probe.types import Array

# sRGB of everyday pigments under white light, chosen by eye: paint and plastic are never pure.
NAMED: dict[str, tuple[int, int, int]] = {
    "red": (178, 34, 36),
    "orange": (232, 118, 28),
    "yellow": (240, 200, 44),
    "green": (52, 124, 62),
    "teal": (24, 130, 130),
    "blue": (36, 78, 158),
    "purple": (104, 56, 132),
    "pink": (232, 140, 164),
    "brown": (110, 70, 42),
    "tan": (194, 156, 108),
    "beige": (226, 211, 180),
    "white": (240, 238, 232),
    "gray": (128, 129, 130),
    "black": (34, 34, 36),
    "silver": (186, 188, 191),
    "gold": (202, 160, 74),
}
SHADES = {"light": ((250, 250, 248), 0.45), "dark": ((12, 12, 14), 0.4)}


def rgb(colour: str) -> Array:
    """sRGB in 0-1, float32, shape (3,), of a name ("light blue") or of "#rrggbb".

    Raises:
        UnknownName: Neither.
    """
    if re.fullmatch(r"#[0-9a-f]{6}", colour):
        channels = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
        return np.array(channels, dtype=np.float32) / 255
    shade, _, name = colour.rpartition(" ")
    if name not in NAMED or shade not in ("", *SHADES):
        raise UnknownName("colour", colour, list(NAMED))
    base = np.array(NAMED[name], dtype=np.float32)
    if shade:
        other, share = SHADES[shade]
        base = base * (1 - share) + np.array(other, dtype=np.float32) * share
    return base / 255
