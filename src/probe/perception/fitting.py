"""How well a description fits a thing, word by word. Knows only what is said and what shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from probe.perception.called import CONTENTS_WORTH, DESCRIPTION_WORTH, own_worth
from probe.perception.nouns import ALIKE
from probe.perception.things import Words
from probe.perception.tokens import is_colour
from probe.perception.wanted import Wanted
from probe.perception.worth import may_have, worth_of

_COLOUR_WEIGHT = 1.5
_WORD_WEIGHT = 1.5
_NOUN_WEIGHT = 3.0
_IDLE_WEIGHT = 0.5
"""Of a word that fits nothing at all, or tells little: a shade, "toy", what comes after "with"."""

_SLIGHT = frozenset(("light", "dark", "bright", "deep", "toy", "model", "plastic", "old", "new"))

_UNKNOWN_WORTH = 0.35
"""Of any noun for something that can't be named: it may be that, too."""


@dataclass(frozen=True)
class Fit:
    """How well something fits.

    Attributes:
        score: Weighted share of the words that fit, 0 to 1.
        allowed: Whether it has the required colour, or one of several.
        like: Whether it may go by what was asked for, or looks like that.
        literal: Whether its own words say what is asked for, so that no likeness was needed.
        whole: Whether it is literal, and all the other words fit, too.
    """

    score: float
    allowed: bool
    like: bool
    literal: bool
    whole: bool


def fits(wanted: Wanted, things: Sequence[Words]) -> list[Fit]:
    """How well each of the things that are told so fits."""
    worths = [[worth_of(word, wanted.noun, words) for word in wanted.words] for words in things]
    weights = [
        _weight(word, wanted, any(row[place] > 0 for row in worths))
        for place, word in enumerate(wanted.words)
    ]
    return [_fit(wanted, weights, row, words) for row, words in zip(worths, things, strict=True)]


def _fit(wanted: Wanted, weights: Sequence[float], worths: Sequence[float], words: Words) -> Fit:
    by_word = dict(zip(wanted.words, worths, strict=True))
    noun = wanted.noun
    like = noun is None or by_word[noun] >= ALIKE
    if noun is not None and words.name is None:
        by_word[noun] = max(by_word[noun], _UNKNOWN_WORTH)
    gained = sum(weight * worth for weight, worth in zip(weights, by_word.values(), strict=True))
    own = 1.0 if noun is None else own_worth(noun, noun, words)
    return Fit(
        gained / sum(weights) if weights else 0.0,
        not wanted.required or any(may_have(colour, words) for colour in wanted.required),
        like,
        own >= DESCRIPTION_WORTH,
        own >= (CONTENTS_WORTH if words.name else DESCRIPTION_WORTH)
        and all(_says_so(*each) for each in by_word.items() if each[0] not in wanted.aside),
    )


def _says_so(word: str, worth: float) -> bool:
    """Whether what a word is worth for a thing leaves no doubt; colours are easily mixed up."""
    return worth == 1 if is_colour(word) else worth > 0


def _weight(word: str, wanted: Wanted, fits_something: bool) -> float:
    if word == wanted.noun:
        return _NOUN_WEIGHT
    if word in wanted.after or word in _SLIGHT or not fits_something:
        return _IDLE_WEIGHT
    return _COLOUR_WEIGHT if is_colour(word) else _WORD_WEIGHT
