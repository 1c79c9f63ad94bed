"""What a description asks for, taken apart. Knows no things."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from probe.perception.phrase import (
    GENERIC,
    SPATIAL,
    afterthought,
    head,
    main_phrase,
    surroundings,
)
from probe.perception.tokens import is_colour, tokens


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
