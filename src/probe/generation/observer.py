"""A rule-based observer: answers from the first picture alone. Published beside every suite.

It gets what is seen, the question and the options, never the truth; it should do no better than
chance.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.generation.colour_words import colours_in
from probe.generation.first_look import FirstLook, VisibleThing
from probe.tasks.english import plural
from probe.tasks.task import LETTERS, NONE_OF_THE_ABOVE, PAIR, Letter, QuestionType
from probe.tasks.type_rules import Form
from probe.types import Array

_RESEMBLES = 25.0
"""CIEDE2000 difference up to which a patch might belong to what an option describes."""


def observe(
    question_type: QuestionType, form: Form, question: str, options: Sequence[str], look: FirstLook
) -> Letter:
    """Answer by a fixed rule.

    Count: what is seen. Size: by what shows, the longer box or the larger area. Compare: by the
    colours that show. Beneath, Reduce, Find: what is half hidden (next to what the question
    names, if it names something) has the colour of the option that is nearest to it; none if
    nothing is.

    Args:
        question_type: Type of the question.
        form: What exactly it asks.
        question: Its words.
        options: Their texts, from A on.
        look: What the first picture shows.
    """
    if question_type == "count":
        return offered(str(visible_count(question, look)), options)
    if question_type == "size":
        return _larger(form, *marked(look))
    if question_type == "compare":
        return _nearer(form, question, look)
    return _resembling(question, options, look)


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


def _larger(form: Form, a: VisibleThing, b: VisibleThing) -> Letter:
    one, other = (_diagonal(a), _diagonal(b)) if form == "longer" else (a.area_px, b.area_px)
    return "A" if (one > other) != (form == "smaller") else "B"


def _diagonal(thing: VisibleThing) -> float:
    left, top, right, bottom = thing.box_px
    return float(np.hypot(right - left, bottom - top))


def _nearer(form: Form, question: str, look: FirstLook) -> Letter:
    a, b = (np.array(thing.lab) for thing in marked(look))
    wanted = None if form == "darker" else wanted_colour(question, look)
    if wanted is None:
        return "A" if a[0] < b[0] else "B"
    return "A" if ciede2000(a, wanted) < ciede2000(b, wanted) else "B"


def _resembling(question: str, options: Sequence[str], look: FirstLook) -> Letter:
    patches = half_hidden(question, look)
    named = [text for text in options if text != NONE_OF_THE_ABOVE]
    best = min(named, key=lambda text: misfit(text, patches))
    fits = misfit(best, patches) <= _RESEMBLES
    return offered(best if fits else NONE_OF_THE_ABOVE, options)
