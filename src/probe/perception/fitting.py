"""How well a description fits a thing, word by word. Knows only what is said and what shows."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from probe.perception.called import (
    CONTENTS_WORTH,
    DESCRIPTION_WORTH,
    contents,
    names,
    nouns,
    own_worth,
    told,
)
from probe.perception.looks import may_look
from probe.perception.nouns import (
    ABOVE,
    ALIKE,
    LOOKS,
    SIBLING,
    kin,
    looks_meant,
    names_meant,
    outlines_meant,
)
from probe.perception.phrase import (
    GENERIC,
    SPATIAL,
    afterthought,
    head,
    main_phrase,
    surroundings,
)
from probe.perception.things import Words
from probe.perception.tokens import colour_likeness, is_colour, tokens

_COLOUR_WEIGHT = 1.5
_WORD_WEIGHT = 1.5
_NOUN_WEIGHT = 3.0
_IDLE_WEIGHT = 0.5
"""Of a word that fits nothing at all, or tells little: a shade, "toy", what comes after "with"."""

_SLIGHT = frozenset(("light", "dark", "bright", "deep", "toy", "model", "plastic", "old", "new"))
_COLOURFUL = frozenset(("colorful", "colourful", "multicolored", "multicoloured", "rainbow"))

_UNKNOWN_WORTH = 0.35
"""Of any noun for something that can't be named: it may be that, too."""


@dataclass(frozen=True)
class Wanted:
    """What a description asks for.

    Attributes:
        words: Its words but for places and those that fit everything.
        noun: What it is about; None without such a word.
        required: Colours of the thing itself, not of something "with" it.
        after: Words that are said after "with", "on" and the like.
        aside: Those of them that tell what is around it.
    """

    words: tuple[str, ...]
    noun: str | None
    required: frozenset[str]
    after: frozenset[str]
    aside: frozenset[str]

    @staticmethod
    def of(description: str, spatial_nouns: Collection[str] = ()) -> Wanted:
        """What words ask for.

        Args:
            description: The words.
            spatial_nouns: Words of SPATIAL that are in the names of things that show.
        """
        said = tokens(description)
        noun = head(description, spatial_nouns)
        words = dict.fromkeys(w for w in said if w == noun or w not in SPATIAL.keys() | GENERIC)
        required = frozenset(filter(is_colour, tokens(main_phrase(description))))
        if noun and is_colour(noun):
            # "an orange" is a fruit, "the orange one" isn't.
            fruit = len(words) == 1 and not GENERIC & set(said)
            noun, required = (noun, frozenset[str]()) if fruit else (None, required)
        main = frozenset(tokens(main_phrase(description))) | {noun}
        after = frozenset(tokens(afterthought(description))) - main
        aside = after & frozenset(tokens(surroundings(description)))
        return Wanted(tuple(words), noun, required, after, aside)


@dataclass(frozen=True)
class Fit:
    """How well something fits.

    Attributes:
        score: Weighted share of the words that fit, 0 to 1.
        allowed: Whether it has the required colour, or one of several.
        like: Whether it may go by what was asked for, or looks like that.
        literal: Whether its own words say what is asked for, so that no likeness was needed.
        whole: Whether it is literal, all other words fit, too, and it is no part of the thing.
    """

    score: float
    allowed: bool
    like: bool
    literal: bool
    whole: bool


def fits(wanted: Wanted, things: Sequence[Words]) -> list[Fit]:
    """How well each of the things that are told so fits."""
    worths = [[_worth(word, wanted.noun, words) for word in wanted.words] for words in things]
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
    literal = own >= DESCRIPTION_WORTH
    return Fit(
        gained / sum(weights) if weights else 0.0,
        not wanted.required or any(_has(colour, words) for colour in wanted.required),
        like,
        literal,
        literal
        and (own >= CONTENTS_WORTH or words.name is None)
        and all(worth > 0 for word, worth in by_word.items() if word not in wanted.aside),
    )


def _weight(word: str, wanted: Wanted, fits_something: bool) -> float:
    if word == wanted.noun:
        return _NOUN_WEIGHT
    if word in wanted.after or word in _SLIGHT or not fits_something:
        return _IDLE_WEIGHT
    return _COLOUR_WEIGHT if is_colour(word) else _WORD_WEIGHT


def _worth(word: str, noun: str | None, words: Words) -> float:
    """How well one word fits a thing, 0 to 1."""
    own = own_worth(word, noun, words)
    if is_colour(word) and word != noun:
        return max(own, max((colour_likeness(word, c) for c in _colours(words)), default=0.0))
    if word in _COLOURFUL and len(words.colours) > 1:
        return max(own, LOOKS)
    alike = _best(looks_meant(word), names(words) | told(words))
    return max(own, alike, _noun_worth(word, words) if word == noun else 0.0)


def _has(colour: str, words: Words) -> bool:
    """Whether a thing has a colour, or if only a part of it shows: whether it may have it."""
    if words.name is None:
        return any(may_look(colour, seen) for seen in _colours(words))
    return _worth(colour, None, words) > 0


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
