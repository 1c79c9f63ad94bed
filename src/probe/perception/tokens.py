"""Words of a description, cut down to what can be compared. English only."""

from __future__ import annotations

import re
from collections.abc import Iterable

from probe.perception.nouns import apart, vocabulary

_STOP = frozenset(
    (
        *("a", "an", "the", "this", "that", "these", "those", "its", "it", "my", "some", "any"),
        *("of", "on", "in", "at", "with", "to", "near", "by", "from", "for", "under", "beside"),
        *("and", "or", "is", "are", "colored", "coloured", "color", "colour", "which", "like"),
        *("look", "looks", "looking", "shaped", "sized", "very", "quite", "maybe", "probably"),
    )
)

_SAME = {
    "grey": "gray", "violet": "purple", "lilac": "purple", "lavender": "purple", "mauve": "purple",
    "indigo": "blue", "cobalt": "blue", "emerald": "green",
    "turquoise": "teal", "cyan": "teal", "aqua": "teal", "navy": "blue", "azure": "blue",
    "maroon": "red", "crimson": "red", "scarlet": "red", "burgundy": "red", "magenta": "pink",
    "fuchsia": "pink", "golden": "gold", "bronze": "gold", "silvery": "silver", "chrome": "silver",
    "ivory": "white", "khaki": "tan", "charcoal": "gray", "amber": "orange", "pale": "light",
    "reddish": "red", "orangish": "orange", "yellowish": "yellow", "greenish": "green",
    "bluish": "blue", "purplish": "purple", "pinkish": "pink", "brownish": "brown",
    "grayish": "gray", "greyish": "gray", "whitish": "white", "blackish": "black",
}  # fmt: skip
_IRREGULAR = {
    "knives": "knife", "loaves": "loaf", "leaves": "leaf", "mice": "mouse", "teeth": "tooth",
    "tomatoes": "tomato", "potatoes": "potato", "mangoes": "mango", "cookies": "cookie",
    "dominoes": "domino", "brownies": "brownie", "geese": "goose", "wolves": "wolf",
    "glasses": "glass", "lens": "lens", "thermos": "thermos", "rhinoceros": "rhinoceros",
    "triceratops": "triceratops", "clothes": "clothing",
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
# The words for what is dark or light stand in the names of colours: "dark blue".
_REMOTE = (
    *({"white", "gray"}, {"white", "light"}, {"gray", "beige"}, {"gray", "blue"}),
    *({"black", "dark"}, {"black", "brown"}, {"black", "blue"}, {"gold", "brown"}),
    *({"gold", "orange"}, {"gold", "tan"}, {"yellow", "orange"}, {"yellow", "green"}),
    *({"pink", "orange"}, {"pink", "beige"}, {"purple", "red"}),
)
_COLOURS = frozenset(
    (
        *("white", "gray", "black", "silver", "gold", "red", "orange", "yellow", "green"),
        *("teal", "blue", "purple", "pink", "brown", "tan", "beige"),
    )
)
MIXED_UP, REMOTE = 0.5, 0.25
"""What a colour is worth that people take often, or now and then, for the one that is wanted."""


def tokens(text: str) -> list[str]:
    """Lower-case words in their order, without articles and the like, in the singular.

    Single letters go ("T-rex", "child's"), and words that may be written as one or as two come
    out alike ("tea pot", "teapot").
    """
    words = [word for word in re.findall(r"[a-z0-9]+", text.lower()) if word not in _STOP]
    found = [_SAME.get(word, _singular(word)) for word in words if len(word) > 1 or word.isdigit()]
    return _joined(piece for word in found for piece in apart(word))


def is_colour(token: str) -> bool:
    """Whether a token is the name of a colour."""
    return token in _COLOURS


def colour_match(wanted: str, actual: str) -> float:
    """1 for the same colour, MIXED_UP for one that people often take for it, else 0."""
    if wanted == actual:
        return 1.0
    return MIXED_UP if {wanted, actual} in _NEAR else 0.0


def colour_likeness(wanted: str, actual: str) -> float:
    """As colour_match, but REMOTE for a colour that people take for it now and then."""
    return colour_match(wanted, actual) or (REMOTE if {wanted, actual} in _REMOTE else 0.0)


def _joined(words: Iterable[str]) -> list[str]:
    found: list[str] = []
    for word in words:
        if found and found[-1] + word in vocabulary():
            found[-1] += word
        else:
            found.append(word)
    return found


def _singular(word: str) -> str:
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if len(word) <= 3 or word.endswith(("ss", "us", "is")):
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "xes", "sses")):
        return word[:-2]
    return word[:-1] if word.endswith("s") else word
