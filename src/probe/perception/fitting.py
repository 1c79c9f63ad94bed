"""How well a description fits a thing, word by word. Knows only what is said and what shows."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from probe.perception.nouns import looks_meant, names_meant, outlines_meant
from probe.perception.things import Words
from probe.perception.tokens import GENERIC, SPATIAL, colour_match, head, is_colour, tokens

_COLOUR_WEIGHT = 1.0
_WORD_WEIGHT = 2.0
_NOUN_WEIGHT = 3.0
_IDLE_WEIGHT = 0.5
"""Of a word that fits nothing at all and so can't tell one thing from another."""

_DESCRIPTION_WORTH = 0.7
_MENTION_WORTH = 0.3
"""Of a noun that is only mentioned beside the thing: a "bowl" in the picture on a cereal box."""

_PART_WORTH = 0.9
"""Of a noun that is in a thing's name but not what the thing is: a "pot" in a "pot lid"."""

_AFTERTHOUGHT = re.compile(r"\b(?:with|on|in|at|near|by|beside|next|under)\b")


@dataclass(frozen=True)
class Wanted:
    """What a description asks for.

    Attributes:
        words: Its words but for places and those that fit everything.
        noun: What it is about; None without such a word.
        required: Colours of the thing itself, not of something "with" it.
    """

    words: tuple[str, ...]
    noun: str | None
    required: frozenset[str]

    @staticmethod
    def of(description: str) -> Wanted:
        """What words ask for."""
        words = [w for w in tokens(description) if w not in SPATIAL and w not in GENERIC]
        main = _AFTERTHOUGHT.split(description.lower())[0]
        noun = head(description)
        required = frozenset(word for word in tokens(main) if is_colour(word))
        return Wanted(tuple(words), None if noun and is_colour(noun) else noun, required)


@dataclass(frozen=True)
class Fit:
    """How well something fits.

    Attributes:
        score: Weighted share of the words that fit, 0 to 1.
        allowed: Whether every required colour is there.
        literal: Whether its own words say what is asked for, so that no likeness was needed.
    """

    score: float
    allowed: bool
    literal: bool


def fits(wanted: Wanted, told: Sequence[Words]) -> list[Fit]:
    """How well each of the things that are told so fits."""
    worths = [[_worth(word, wanted.noun, words) for word in wanted.words] for words in told]
    weights = [
        _weight(word, wanted.noun, any(row[place] > 0 for row in worths))
        for place, word in enumerate(wanted.words)
    ]
    return [_fit(wanted, weights, row, words) for row, words in zip(worths, told, strict=True)]


def _fit(wanted: Wanted, weights: Sequence[float], worths: Sequence[float], words: Words) -> Fit:
    gained = sum(weight * worth for weight, worth in zip(weights, worths, strict=True))
    by_word = dict(zip(wanted.words, worths, strict=True))
    return Fit(
        gained / sum(weights) if weights else 0.0,
        all(by_word[colour] > 0 for colour in wanted.required),
        wanted.noun is None or _own_worth(wanted.noun, wanted.noun, words) >= _DESCRIPTION_WORTH,
    )


def _weight(word: str, noun: str | None, fits_something: bool) -> float:
    if word == noun:
        return _NOUN_WEIGHT
    if not fits_something:
        return _IDLE_WEIGHT
    return _COLOUR_WEIGHT if is_colour(word) else _WORD_WEIGHT


def _worth(word: str, noun: str | None, words: Words) -> float:
    """How well one word fits a thing, 0 to 1."""
    own = _own_worth(word, noun, words)
    if is_colour(word) and word != noun:
        every = {token for colour in words.colours for token in tokens(colour)}
        return max(own, max((colour_match(word, c) for c in every | _names(words)), default=0.0))
    alike = _best(looks_meant(word), _names(words) | _described(words))
    if word == noun:
        alike = max(alike, _best(names_meant(word), _nouns(words)))
        if words.name is None:
            alike = max(alike, _best(outlines_meant(word), _described(words)))
    return max(own, alike)


def _own_worth(word: str, noun: str | None, words: Words) -> float:
    """What a word is worth for a thing because it is in the thing's own words."""
    if word in _names(words):
        return _PART_WORTH if word == noun and word not in _nouns(words) else 1.0
    if word not in _described(words):
        return 0.0
    aside = word == noun and word not in _main_phrase(words)
    return _MENTION_WORTH if aside else _DESCRIPTION_WORTH


def _best(meant: Mapping[str, float], words: Iterable[str]) -> float:
    return max((meant.get(word, 0.0) for word in words), default=0.0)


@lru_cache(1024)
def _names(words: Words) -> frozenset[str]:
    return frozenset(tokens(f"{words.name or ''} {words.category}"))


@lru_cache(1024)
def _described(words: Words) -> frozenset[str]:
    return frozenset(tokens(words.description))


@lru_cache(1024)
def _main_phrase(words: Words) -> frozenset[str]:
    return frozenset(tokens(_AFTERTHOUGHT.split(words.description.lower())[0]))


@lru_cache(1024)
def _nouns(words: Words) -> frozenset[str]:
    """What a thing is: the main nouns of its category and name, and what it is a piece "of"."""
    named = [text for text in (words.category, words.name) if text]
    heads = {noun for text in named if (noun := head(text))}
    of = [text.split(" of ", 1)[1] for text in named if " of " in text]
    return frozenset(heads | {noun for text in of if (noun := head(text))})
