"""A rule-based observer: answers from the first picture alone. Published beside every suite.

It gets what is seen, the question and the options, never the truth; it should do no better than
chance.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.generation.first_look import FirstLook, VisibleThing
from probe.perception.colour_words import colours_in
from probe.tasks.english import plural
from probe.tasks.registry import part_of
from probe.tasks.task import LETTERS, NONE_OF_THE_ABOVE, PAIR, Letter, QuestionType
from probe.tasks.type_rules import Form
from probe.types import Array

_RESEMBLES = 25.0
"""CIEDE2000 difference up to which a patch might belong to what an option describes."""


Answering = Callable[[Form, str, Sequence[str], FirstLook], Letter]
"""Form, words of the question, texts of the options, and the first look, to a letter."""


@dataclass(frozen=True)
class Observer:
    """A type's fixed rule; the part "observer" of a question type.

    Attributes:
        answer: The rule.
        by_colour: Whether it goes by the colours that show of two marked things.
    """

    answer: Answering
    by_colour: bool = False


def observer_of(question_type: QuestionType) -> Observer:
    """The fixed rule of a type.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: Its observer can't be used.
    """
    return part_of(question_type, "observer", Observer)


def observe(
    question_type: QuestionType, form: Form, question: str, options: Sequence[str], look: FirstLook
) -> Letter:
    """Answer by the type's fixed rule.

    Args:
        question_type: Type of the question.
        form: What exactly it asks.
        question: Its words.
        options: Their texts, from A on.
        look: What the first picture shows.
    """
    return observer_of(question_type).answer(form, question, options, look)


def offered(text: str, options: Sequence[str]) -> Letter:
    """The letter of an option; that of the last one, "none of the above", if it isn't offered."""
    place = options.index(text) if text in options else len(options) - 1
    return LETTERS[place]


def marked(look: FirstLook) -> tuple[VisibleThing, VisibleThing]:
    """What lies at the marks A and B."""
    a, b = (look.things[look.marked[letter]] for letter in PAIR)
    return a, b


def visible_count(question: str, look: FirstLook) -> int:
    """How many things are seen whose plural the question names."""
    names = {thing.name for thing in look.things if thing.name}
    named = [name for name in names if (many := plural(name)) and says(question, many)]
    return len(look.called(max(named, key=len))) if named else 0


def named_in(question: str, look: FirstLook) -> tuple[int, ...]:
    """Places of the seen things that a question names."""
    return tuple(
        place
        for place, thing in enumerate(look.things)
        if thing.name and says(question, thing.name)
    )


def says(question: str, words: str) -> bool:
    """Whether a question has these words, whole and in this order."""
    return re.search(rf"\b{re.escape(words)}\b", question) is not None


def half_hidden(question: str, look: FirstLook) -> tuple[VisibleThing, ...]:
    """What shows too little to be named: next to what the question names, if it names something."""
    near = {other for place in named_in(question, look) for other in look.meeting(place)}
    places = near or range(len(look.things))
    return tuple(look.things[place] for place in places if look.things[place].name is None)


def wanted_colour(question: str, look: FirstLook) -> Array | None:
    """The colour that Compare asks for: of the thing it names, else by the word; None if darker."""
    named = named_in(question, look)
    if named:
        longest = max(named, key=lambda place: len(look.things[place].name or ""))
        return np.array(look.things[longest].lab)
    words = colours_in(question)
    return words[-1] if words else None


def misfit(option: str, patches: Sequence[VisibleThing]) -> float:
    """How far the colours of patches are from those that an option's text names; inf if none."""
    pairs = [(word, np.array(patch.lab)) for word in colours_in(option) for patch in patches]
    return min((float(ciede2000(one, other)) for one, other in pairs), default=float("inf"))


def resembling(form: Form, question: str, options: Sequence[str], look: FirstLook) -> Letter:
    """The option whose colour is nearest to what is half hidden, or none if nothing is.

    That is next to what the question names, if it names something.
    """
    patches = half_hidden(question, look)
    named = [text for text in options if text != NONE_OF_THE_ABOVE]
    best = min(named, key=lambda text: misfit(text, patches))
    fits = misfit(best, patches) <= _RESEMBLES
    return offered(best if fits else NONE_OF_THE_ABOVE, options)
