"""The words that a thing goes by, and what each is worth for it. Knows nothing of what is asked."""

from __future__ import annotations

from functools import lru_cache

from probe.perception.nouns import holds, is_kind
from probe.perception.phrase import SPATIAL, head, main_phrase
from probe.perception.things import Words
from probe.perception.tokens import is_colour, tokens

DESCRIPTION_WORTH = 0.7
"""Of a word that only the description holds."""

CONTENTS_WORTH = 0.9
"""Of a noun that tells what is in a package: a "ketchup" for a "ketchup bottle"."""

_PART_WORTH = 0.45
"""Of a noun that is in a thing's name but not what the thing is: a "pot" in a "pot lid"."""

_MENTION_WORTH = 0.3
"""Of a noun that is only mentioned beside the thing: a "bowl" in the picture on a cereal box; or
that is the thing's colour: an "orange" for an orange mug."""

_FIGURES = frozenset(("figurine", "figure", "statue", "statuette", "sculpture", "toy", "plush"))


def own_worth(word: str, noun: str | None, words: Words) -> float:
    """What a word is worth for a thing because it is in the thing's own words, 0 to 1.

    Args:
        word: In the form of `tokens`.
        noun: What the description that holds it is about.
        words: The thing's.
    """
    if word in names(words):
        if word != noun or word in nouns(words):
            return 1.0
        if is_colour(word):
            return _MENTION_WORTH
        return CONTENTS_WORTH if word in contents(words) else _PART_WORTH
    if word not in told(words):
        return 0.0
    aside = word == noun and word not in _main_words(words)
    return _MENTION_WORTH if aside else DESCRIPTION_WORTH


@lru_cache(1024)
def names(words: Words) -> frozenset[str]:
    """All words of its names and its category."""
    return frozenset(tokens(" ".join((words.name or "", words.category, *words.synonyms))))


@lru_cache(1024)
def told(words: Words) -> frozenset[str]:
    """All words of its description, and of the kind that texts call it by."""
    return frozenset(tokens(f"{words.description} {words.kind or ''}"))


@lru_cache(1024)
def nouns(words: Words) -> frozenset[str]:
    """What it is: the main nouns of its category and name, and what it is a piece "of"."""
    named = [text for text in (words.category, words.name, *words.synonyms) if text]
    named += [text.split(" of ", 1)[1] for text in named if " of " in text]
    heads = {noun for text in named if (noun := head(text, SPATIAL))}
    return frozenset(heads | {shown for text in named if (shown := _depicted(text))})


@lru_cache(1024)
def contents(words: Words) -> frozenset[str]:
    """What is in it, if it is a package: the other words of its name."""
    own = nouns(words)
    return names(words) - own if any(map(holds, own)) else frozenset()


def _depicted(text: str) -> str | None:
    """What a figure is of, or which fruit: the word before "figurine", "fruit" and the like."""
    words = tokens(main_phrase(text))
    general = len(words) > 1 and (words[-1] in _FIGURES or is_kind(words[-1]))
    return words[-2] if general and not is_colour(words[-2]) else None


@lru_cache(1024)
def _main_words(words: Words) -> frozenset[str]:
    return frozenset(tokens(f"{main_phrase(words.description)} {words.kind or ''}"))
