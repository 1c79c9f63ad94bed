"""What a detector calls a thing that tells its kind alone. Knows categories, no things."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import cast

import yaml

from probe.perception.tokens import is_colour

_SHADES = ("light", "dark")

UNKNOWN = "object"
"""The kind of what belongs to none."""


@cache
def kinds() -> dict[str, str]:
    """The kind of each category."""
    text = (files("probe.perception") / "data/general.yaml").read_text("utf-8")
    listed = cast(dict[str, list[str]], yaml.load(text, yaml.CSafeLoader))
    return {category: kind for kind, members in listed.items() for category in members}


@cache
def kinds_told() -> frozenset[str]:
    """All that a thing may be called."""
    return frozenset((*kinds().values(), UNKNOWN))


def kinds_in(name: str) -> frozenset[str]:
    """The kinds that a thing of this name may be of: those of categories that end in its words.

    "White open box" may be a box, as a cardboard box is, or a container, as any box. Colours count
    at the end alone ("small orange"). Empty where no category ends so.
    """
    words = name.lower().split()
    telling = [it for it in words[:-1] if not is_colour(it) and it not in _SHADES] + words[-1:]
    return frozenset(kind for it in telling for kind in _of_last_words().get(it, ()))


@cache
def _of_last_words() -> dict[str, frozenset[str]]:
    found = dict[str, frozenset[str]]()
    for category, kind in kinds().items():
        word = category.split()[-1]
        found[word] = found.get(word, frozenset()) | {kind}
    return found


def kind_of(category: str) -> str:
    """The kind of a category: "fruit" of "lime"."""
    return kinds().get(category, UNKNOWN)
