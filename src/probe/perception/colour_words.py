"""What colour words mean, roughly, in CIELAB. Knows no objects."""

from __future__ import annotations

import re

import numpy as np

from probe.assets.colour.names import lab
from probe.types import Array

# sRGB of plain things in soft light, chosen by eye.
_WORDS = {
    "beige": (220, 200, 165), "black": (35, 35, 36), "blue": (45, 90, 175),
    "brown": (110, 72, 45), "gold": (195, 155, 70), "gray": (125, 125, 125),
    "green": (60, 140, 65), "orange": (230, 120, 35), "pink": (232, 140, 165),
    "purple": (115, 65, 145), "red": (195, 42, 42), "silver": (180, 182, 185),
    "tan": (200, 165, 120), "teal": (30, 140, 140), "white": (238, 238, 235),
    "yellow": (240, 208, 60),
}  # fmt: skip
KNOWN = tuple(_WORDS)
"""Colours that have a meaning, also with "light" or "dark" before them."""

_SHADES = {"light": 18.0, "dark": -18.0}
_NAMED = re.compile(rf"\b(?:(light|dark) )?({'|'.join(_WORDS)})\b")
_COLOUR = rf"(?:(?:light|dark) )?(?:{'|'.join(_WORDS)})"
_FIRST = re.compile(rf"\b{_COLOUR}(?: and {_COLOUR})*\b")


def colours_in(text: str) -> tuple[Array, ...]:
    """Colours that a text names, in its order, CIELAB, each of shape (3,)."""
    return tuple(_meant(shade, word) for shade, word in _NAMED.findall(text.lower()))


def colour_words_in(text: str) -> frozenset[str]:
    """Colours that a text names, in words: "light blue", "red"."""
    return frozenset(" ".join(filter(None, found)) for found in _NAMED.findall(text.lower()))


def first_colours(text: str) -> str:
    """The first colours that a description names: "white and red"; empty if it names none."""
    found = _FIRST.search(text.lower())
    return found[0] if found else ""


def _meant(shade: str, word: str) -> Array:
    plain = lab(np.array([_WORDS[word]]))[0]
    return plain + (_SHADES.get(shade, 0.0), 0.0, 0.0)
