"""What a scripted agent needs of a question type: how to go about it. Knows none of the types."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from probe.agents.moves import Plan, Way
from probe.agents.phrases import Say, silent
from probe.agents.reading import Graph
from probe.episodes.turns import Question
from probe.tasks.registry import part_of


@dataclass(frozen=True, eq=False)
class ScriptedQuestion:
    """One question for a scripted agent, and how it is to go about it.

    Attributes:
        question: As it is asked.
        subject, form: As for Scripted.
        first: What it tries first on things that are in the way.
        rng: Breaks ties.
        bold: Whether it guesses where it lacks evidence.
        say: Gives the words that go with each call.
    """

    question: Question
    subject: str
    form: str
    first: Way
    rng: np.random.Generator
    bold: bool = False
    say: Say = silent


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


def hidden_at_first(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """No answer: a first look never shows the evidence."""
    return None


@dataclass(frozen=True)
class TypePlan:
    """How a scripted agent goes about a type; the part "plan" of a question type.

    Attributes:
        begin: Makes the calls of an episode; it answers on evidence or, unless bold, not at all.
        at_sight: Answers where the first look shows the evidence, else None.
    """

    begin: Callable[[ScriptedQuestion], Plan[None]]
    at_sight: Callable[[FirstLookQuestion, Say], FirstLookAnswer | None] = hidden_at_first


def plan_for(question_type: str) -> TypePlan:
    """How to go about a type.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: Its plan can't be used.
    """
    return part_of(question_type, "plan", TypePlan)
