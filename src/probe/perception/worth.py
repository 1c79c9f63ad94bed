"""What a word is worth for a thing, by its own words, by its looks and by general English."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from probe.perception.called import CONTENTS_WORTH, contents, names, nouns, own_worth, told
from probe.perception.looks import may_look
from probe.perception.nouns import (
    ABOVE,
    LOOKS,
    SIBLING,
    kin,
    looks_meant,
    names_meant,
    outlines_meant,
)
from probe.perception.things import Words
from probe.perception.tokens import MIXED_UP, colour_likeness, is_colour, tokens

_COLOURFUL = frozenset(("colorful", "colourful", "multicolored", "multicoloured", "rainbow"))


def worth_of(word: str, noun: str | None, words: Words) -> float:
    """How well one word fits a thing, 0 to 1.

    Args:
        word: In the form of `tokens`.
        noun: What the description that holds it is about.
        words: The thing's.
    """
    own = own_worth(word, noun, words)
    if is_colour(word) and word != noun:
        return max(own, max((colour_likeness(word, c) for c in _colours(words)), default=0.0))
    if word in _COLOURFUL and len(words.colours) > 1:
        return max(own, LOOKS)
    alike = _best(looks_meant(word), names(words) | told(words))
    return max(own, alike, _noun_worth(word, words) if word == noun else 0.0)


def may_have(colour: str, words: Words) -> bool:
    """Whether a thing has a colour, or if only a part of it shows: whether it may have it."""
    if words.name is None:
        return any(may_look(colour, seen) for seen in _colours(words))
    return worth_of(colour, None, words) >= MIXED_UP


def _colours(words: Words) -> frozenset[str]:
    every = {token for colour in words.colours for token in tokens(colour)}
    return names(words) | every


def _noun_worth(noun: str, words: Words) -> float:
    """What a noun is worth for a thing that goes by other words."""
    if words.name is None:
        return _best(outlines_meant(noun), told(words))
    meant = names_meant(noun)
    held = CONTENTS_WORTH * _best(meant, contents(words))
    return max(_best(meant, nouns(words)), held, _kin_worth(noun, names(words)))


def _kin_worth(noun: str, named: frozenset[str]) -> float:
    """What a noun is worth for something of its kind."""
    found = 0.0
    for kind, others in kin(noun):
        if others & named:
            found = max(found, SIBLING)
        elif kind in named:
            found = max(found, ABOVE)
    return found


def _best(meant: Mapping[str, float], words: Iterable[str]) -> float:
    return max((meant.get(word, 0.0) for word in words), default=0.0)
