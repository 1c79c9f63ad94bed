"""What the first look alone tells, with reasons; nothing where the evidence is hidden."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from probe.agents.clearing import Search
from probe.agents.marks import Both, at, marks_of
from probe.agents.moves import none_of_them
from probe.agents.pairs import fitting, larger, wanted_colour
from probe.agents.phrases import Say
from probe.agents.reading import Graph, Seen, same
from probe.episodes.turns import Question


@dataclass(frozen=True)
class FirstLookAnswer:
    """An answer and why.

    Attributes:
        letter: Of an option.
        words: The reason.
        point: Pixel (u, v), if one is asked for.
    """

    letter: str
    words: str
    point: tuple[int, int] | None = None


@dataclass(frozen=True)
class FirstLookQuestion:
    """A question, what an agent that can't read is told of it, and the first look.

    Attributes:
        question: As it is asked.
        subject, form: As for Scripted.
        graph: What shows.
    """

    question: Question
    subject: str
    form: str
    graph: Graph


def at_a_glance(question_type: str, asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """The answer if the first look shows its evidence.

    Beneath and Reduce ask for what is hidden: a first look never shows that.

    Args:
        question_type: Type of the question.
        asked: The question and the look.
        say: Gives the words.
    """
    rules: dict[str, Callable[[FirstLookQuestion, Say], FirstLookAnswer | None]] = {
        "compare": _compare,
        "count": _count,
        "find": _find,
        "size": _size,
    }
    rule = rules.get(question_type)
    return rule(asked, say) if rule else None


def _find(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    for letter, text in asked.question.options:
        for seen in asked.graph.called(text):
            slots = {"thing": seen.name or "", "letter": letter}
            return FirstLookAnswer(letter, say("find", slots), seen.point)
    return None


def _count(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """Only if nothing is half hidden and nothing could hide another one."""

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", asked.subject)

    search = Search(counts, "grasp", np.random.default_rng(0), graph=asked.graph)
    if not search.complete:
        return None
    number = str(len(asked.graph.called(asked.subject)))
    letters = [letter for letter, text in asked.question.options if text.strip() == number]
    letter = letters[0] if letters else none_of_them(asked.question)
    if letter is None:
        return None
    occasion = "count" if letters else "count none"
    return FirstLookAnswer(letter, say(occasion, {"number": number, "letter": letter}))


def _size(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """Only if nothing lies on either."""
    one, two = _marked(asked)
    if one is None or two is None or asked.graph.over(one) or asked.graph.over(two):
        return None
    letter = larger(asked.form, one, two)
    slots = {"one": one.name or "", "two": two.name or "", "letter": letter}
    return FirstLookAnswer(letter, say(f"size {asked.form}", slots))


def _compare(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """By colour one of the two that can be named is enough: just one has the colour."""
    both = _marked(asked)
    like = asked.graph.called(asked.subject) if asked.form == "like" else ()
    wanted = wanted_colour(asked.form, asked.subject, like)
    named = [seen for seen in both if seen is not None]
    if not named or (asked.form == "darker" and len(named) < 2):
        return None
    if not wanted and asked.form != "darker":
        return None
    letter = fitting(asked.form, wanted, both)
    return (
        None if letter is None else FirstLookAnswer(letter, _reason(asked.form, letter, both, say))
    )


def _reason(form: str, letter: str, both: Both, say: Say) -> str:
    names = [seen.name or "" for seen in both if seen is not None]
    if len(names) == 2:
        slots = {"one": names[0], "two": names[1], "letter": letter}
        return say("compare darker" if form == "darker" else "compare colour", slots)
    chosen = both["AB".index(letter)] is not None
    slots = {"thing": names[0], "letter": letter}
    return say("sight colour one" if chosen else "sight colour other", slots)


def _marked(asked: FirstLookQuestion) -> Both:
    """What is marked A and B, as far as it can be named."""
    marks = marks_of(asked.question)
    found = [at(asked.graph.objects, marks[letter]) for letter in "AB"]
    one, two = (seen if seen is not None and seen.name is not None else None for seen in found)
    return one, two
