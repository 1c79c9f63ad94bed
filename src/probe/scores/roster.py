"""What a suite consists of, as far as scores care: its tasks, their types, their options."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from probe.scores.row import Row
from probe.tasks.type_rules import rules_of


class Listed(NamedTuple):
    """A task that everybody should have been given.

    Attributes:
        question_type: Question type.
        stratum: Part of the type that is also reported apart, else empty.
        options: Number of options to choose from.
        necessary: Fewest manipulations that it takes; None where it doesn't state that.
    """

    question_type: str
    stratum: str
    options: int
    necessary: int | None = None


Roster = Mapping[str, Listed]
"""Tasks by id."""

Guess = Callable[[Listed], float]
"""How often somebody who moves nothing is right about a task."""


def task_of(row: Row) -> Listed:
    """What a row says of its task."""
    return Listed(row.question_type, row.stratum, row.options, row.necessary)


def roster_of(rows: Iterable[Row]) -> dict[str, Listed]:
    """All tasks that somebody was given; what nobody was given can't be known of from rows."""
    return {row.task: task_of(row) for row in rows}


def guessed(listed: Listed) -> float:
    """How often a blind guess is right; whoever moves nothing removes nothing."""
    return 0.0 if rules_of(listed.question_type).exact else letter_guessed(listed)


def letter_guessed(listed: Listed) -> float:
    """How often the letter of a blind guess is right."""
    return 1 / listed.options


def chance_by_type(roster: Roster, guess: Guess = guessed) -> dict[str, float]:
    """What a blind guess among the options gives, by type: the mean over its tasks.

    In Find it gives less, since the point must be hit as well; the letter alone gives this.
    """
    return _means_by_type(roster, guess)


def naive_by_type(roster: Roster, guess: Guess = guessed) -> dict[str, float]:
    """Share that is right by type without moving anything.

    All tasks that a look answers; of the others what a guess gives, in Count what counting the
    visible ones and adding 0, 1 or 2 does.
    """
    return _means_by_type(roster, partial(_looked, guess))


def _means_by_type(roster: Roster, share: Guess) -> dict[str, float]:
    question_types = sorted({listed.question_type for listed in roster.values()})
    return {
        question_type: float(
            np.mean([share(it) for it in roster.values() if it.question_type == question_type])
        )
        for question_type in question_types
    }


def _looked(guess: Guess, listed: Listed) -> float:
    if listed.necessary == 0:
        return 1.0
    return max(guess(listed), rules_of(listed.question_type).naive)
