"""How a description is built: what it is about, and what it only mentions. English only."""

from __future__ import annotations

import re
from collections.abc import Collection

from probe.perception.tokens import is_colour, tokens

GENERIC = frozenset(("object", "thing", "item", "something", "one", "stuff"))
"""Words that fit everything."""

SPATIAL = {
    "left": "left", "leftmost": "left", "right": "right", "rightmost": "right",
    "top": "top", "topmost": "top", "upper": "top", "uppermost": "top",
    "bottom": "bottom", "bottommost": "bottom", "lower": "bottom", "lowest": "bottom",
    "large": "large", "larger": "large", "largest": "large", "big": "large", "biggest": "large",
    "small": "small", "smaller": "small", "smallest": "small", "tiny": "small", "little": "small",
}  # fmt: skip
"""Words that choose among things, by what they ask for."""

VAGUE = frozenset(("large", "big", "small", "tiny", "little"))
"""Those that many things fit, so that they rank rather than choose."""

_MEASURE = re.compile(
    r"\b(?:piece|pair|bit|kind|sort|type|part|slice|ear|head|clove|lump|sheet|pile|stack) of\b"
)
_PLACES = (
    r"on|at|near|by|beside|next|under|underneath|beneath|below|behind|between|above|over|against"
)
_AFTERTHOUGHT = re.compile(rf"\b(?:with|in|{_PLACES})\b")
_AROUND = re.compile(rf"\b(?:{_PLACES})\b")
_AFTER_NOUN = re.compile(
    rf"\b(?:with|in|of|from|for|inside|{_PLACES}|that|which|who|whose|without|full|filled|like|"
    r"shaped|looks|looking|made|holding|containing|wearing|lying|laying|standing|sitting|leaning|"
    r"sticking|poking|peeking|partly|partially|half|mostly|upside|covered|hidden)\b"
)


def main_phrase(text: str) -> str:
    """What comes before "with", "on" and the like."""
    return _AFTERTHOUGHT.split(text.lower())[0]


def afterthought(text: str) -> str:
    """What comes after "with", "on" and the like."""
    return " ".join(_AFTERTHOUGHT.split(text.lower())[1:])


def surroundings(text: str) -> str:
    """What comes after "on", "next to" and the like: it tells the place more than the thing."""
    return " ".join(_AROUND.split(text.lower())[1:])


def head(text: str, spatial_nouns: Collection[str] = ()) -> str | None:
    """The noun that a description is about: the last word before "with", "on", "of" and the like.

    Args:
        text: The description.
        spatial_nouns: Words of SPATIAL that are nouns if they come last ("spinning top").

    Returns:
        A colour only if there is no other word; None if there is no word at all.
    """
    whole = _MEASURE.sub("", text.lower())
    about = main_phrase(whole)
    parts = [tokens(p) for p in _AFTER_NOUN.split(about if tokens(about) else whole)]
    nouns = [noun for part in parts if (noun := _last(part, spatial_nouns))]
    return next((noun for noun in nouns if not is_colour(noun)), nouns[0] if nouns else None)


def _last(words: list[str], spatial_nouns: Collection[str]) -> str | None:
    if words and words[-1] in SPATIAL and words[-1] in spatial_nouns:
        return words[-1]
    kept = [word for word in words if word not in SPATIAL and word not in GENERIC]
    plain = [word for word in kept if not is_colour(word)]
    return (plain or kept or [None])[-1]
