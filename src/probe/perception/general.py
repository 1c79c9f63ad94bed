"""What a detector calls a thing that tells its kind alone. Knows categories, no things."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import cast

import yaml

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


def kind_in(name: str) -> str | None:
    """The kind of what a name ends with: "fruit" for "small lime"; None if that isn't known."""
    words = name.lower().split()
    ends = (" ".join(words[place:]) for place in range(len(words)))
    whole = next((kinds()[end] for end in ends if end in kinds()), None)
    return whole or _of_last_words().get(words[-1] if words else "")


@cache
def _of_last_words() -> dict[str, str]:
    """Kinds by the last word of categories, the first where several have one."""
    return {category.split()[-1]: kind for category, kind in reversed(kinds().items())}


def kind_of(category: str) -> str:
    """The kind of a category: "fruit" of "lime"."""
    return kinds().get(category, UNKNOWN)
