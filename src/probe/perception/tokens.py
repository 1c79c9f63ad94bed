"""Words of a description, cut down to what can be compared. English only."""

from __future__ import annotations

import re

_STOP = frozenset(
    (
        *("a", "an", "the", "this", "that", "these", "those", "its", "it", "my", "some", "any"),
        *("of", "on", "in", "at", "with", "to", "near", "by", "from", "for", "under", "beside"),
        *("and", "or", "is", "are", "one", "colored", "coloured", "color", "colour"),
    )
)

GENERIC = frozenset(("object", "thing", "item", "something"))
"""Words that fit everything."""

SPATIAL = {
    "left": "left", "leftmost": "left", "right": "right", "rightmost": "right",
    "top": "top", "topmost": "top", "upper": "top", "uppermost": "top",
    "bottom": "bottom", "bottommost": "bottom", "lower": "bottom", "lowest": "bottom",
    "large": "large", "larger": "large", "largest": "large", "big": "large", "biggest": "large",
    "small": "small", "smaller": "small", "smallest": "small", "tiny": "small",
}  # fmt: skip
"""Words that choose among things, by what they ask for."""

_SAME = {
    "grey": "gray", "violet": "purple", "lilac": "purple", "lavender": "purple", "mauve": "purple",
    "turquoise": "teal", "cyan": "teal", "aqua": "teal", "navy": "blue", "azure": "blue",
    "maroon": "red", "crimson": "red", "scarlet": "red", "burgundy": "red", "magenta": "pink",
    "golden": "gold", "silvery": "silver", "chrome": "silver", "ivory": "white",
    "khaki": "tan",
    "reddish": "red", "orangish": "orange", "yellowish": "yellow", "greenish": "green",
    "bluish": "blue", "purplish": "purple", "pinkish": "pink", "brownish": "brown",
    "grayish": "gray", "greyish": "gray", "whitish": "white", "blackish": "black",
}  # fmt: skip
_NEAR = (
    {"gray", "silver"},
    {"gray", "black"},
    {"white", "silver"},
    {"yellow", "gold"},
    {"brown", "tan"},
    {"tan", "beige"},
    {"white", "beige"},
    {"teal", "blue"},
    {"teal", "green"},
    {"pink", "purple"},
    {"pink", "red"},
    {"red", "orange"},
    {"red", "brown"},
    {"orange", "brown"},
    {"orange", "tan"},
    {"yellow", "tan"},
    {"yellow", "beige"},
    {"blue", "purple"},
)
_COLOURS = frozenset(
    (
        *("white", "gray", "black", "silver", "gold", "red", "orange", "yellow", "green"),
        *("teal", "blue", "purple", "pink", "brown", "tan", "beige"),
    )
)
_NEARLY = 0.5
_MEASURE = re.compile(r"\b(?:piece|pair|bit|kind|sort|part|slice) of\b")


def tokens(text: str) -> list[str]:
    """Lower-case words in their order, without articles and the like, in the singular."""
    words = re.findall(r"[a-z0-9]+", text.lower())
    return [_SAME.get(word, _singular(word)) for word in words if word not in _STOP]


def head(text: str) -> str | None:
    """The noun that a description is about: the last word before "with", "on", "of" and the like.

    None if there is no such word.
    """
    whole = _MEASURE.sub("", text.lower())
    before = re.split(r"\b(?:with|on|in|of|at|near|by|under|from|beside|next)\b", whole)[0]
    nouns = [word for word in tokens(before) if word not in SPATIAL and word not in GENERIC]
    return nouns[-1] if nouns else None


def is_colour(token: str) -> bool:
    """Whether a token is the name of a colour."""
    return token in _COLOURS


def colour_match(wanted: str, actual: str) -> float:
    """1 for the same colour, 0.5 for one that people mix up with it, else 0."""
    if wanted == actual:
        return 1.0
    return _NEARLY if {wanted, actual} in _NEAR else 0.0


def _singular(word: str) -> str:
    if len(word) <= 3 or word.endswith(("ss", "us", "is")):
        return word
    if word.endswith("ies"):
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "xes", "sses")):
        return word[:-2]
    return word[:-1] if word.endswith("s") else word
