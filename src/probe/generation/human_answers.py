"""What people's answers say of questions: which to drop, and how far people agree. Pure."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

Reason = Literal["kept", "ambiguous", "failed", "not tried"]


@dataclass(frozen=True)
class HumanAnswer:
    """What came of one person at one question.

    Attributes:
        task: The question.
        question_type: Its type.
        person: Who.
        letter: What they answered; None if they didn't.
        correct: Whether it was right by the question's rules, Find's point included.
        turns, manipulations: How many they used.
        seconds: How long it took, the tools' work included; None if that isn't known.
    """

    task: str
    question_type: str
    person: str
    letter: str | None
    correct: bool
    turns: int
    manipulations: int
    seconds: float | None


@dataclass(frozen=True)
class HumanVerdict:
    """What people make of a question.

    Attributes:
        task: The question.
        people: How many tried it.
        right: How many of them were right.
        notes: Of those who call it ambiguous, by person.
        reason: Why it is dropped, or that it isn't.
    """

    task: str
    people: int
    right: int
    notes: Mapping[str, str]
    reason: Reason

    @property
    def dropped(self) -> bool:
        """Whether it is left out of the new suite; a question that nobody tried stays."""
        return self.reason in ("ambiguous", "failed")


@dataclass(frozen=True)
class Agreement:
    """How often people say the same.

    Attributes:
        name: A type, or "all".
        tasks: Questions that two people or more answered.
        pairs: Pairs of people at one question.
        same: Of these, how many chose the same letter.
        alpha: Krippendorff's, corrected for chance; None where it isn't defined.
    """

    name: str
    tasks: int
    pairs: int
    same: int
    alpha: float | None


@dataclass(frozen=True)
class HumanEffort:
    """What questions of a type took: median, and the 10th and 90th percentile.

    Attributes:
        name: A type, or "all".
        episodes: How many.
        right: How many were right.
        seconds, turns, manipulations: Each as (p10, median, p90); None if nothing is known.
    """

    name: str
    episodes: int
    right: int
    seconds: tuple[float, float, float] | None
    turns: tuple[float, float, float] | None
    manipulations: tuple[float, float, float] | None


def verdicts(
    tasks: Sequence[str],
    said: Iterable[HumanAnswer],
    notes: Mapping[str, Mapping[str, str]],
    *,
    least: float,
    doubters: int = 1,
) -> list[HumanVerdict]:
    """What becomes of each question.

    Args:
        tasks: All questions, in order.
        said: At most one of each person at each question.
        notes: Of each question, by person, why they call it ambiguous.
        least: Share of people who must be right for a question to stay.
        doubters: So many who call it ambiguous drop it, whatever they answered.
    """
    by_task: defaultdict[str, list[HumanAnswer]] = defaultdict(list)
    for each in said:
        by_task[each.task].append(each)
    return [_verdict(task, by_task[task], notes.get(task, {}), least, doubters) for task in tasks]


def _verdict(
    task: str, said: Sequence[HumanAnswer], notes: Mapping[str, str], least: float, doubters: int
) -> HumanVerdict:
    right = sum(each.correct for each in said)
    reason: Reason = "kept" if said else "not tried"
    if len(notes) >= doubters:
        reason = "ambiguous"
    elif said and right / len(said) < least:
        reason = "failed"
    return HumanVerdict(task, len(said), right, notes, reason)


def agreements(said: Sequence[HumanAnswer]) -> list[Agreement]:
    """How far people agree on letters, by type and over all; answers that weren't given are out."""
    return [_agreement(name, part) for name, part in _by_type(said)]


def _agreement(name: str, said: Sequence[HumanAnswer]) -> Agreement:
    units: defaultdict[str, list[str]] = defaultdict(list)
    for each in said:
        if each.letter is not None:
            units[each.task].append(each.letter)
    shared = [letters for letters in units.values() if len(letters) > 1]
    pairs = [pair for letters in shared for pair in combinations(letters, 2)]
    same = sum(first == other for first, other in pairs)
    return Agreement(name, len(shared), len(pairs), same, alpha_of(shared))


def alpha_of(units: Iterable[Sequence[str]]) -> float | None:
    """Krippendorff's alpha for names: 1 is full agreement, 0 what chance gives.

    alpha = 1 - (n - 1) D / E, with D the disagreement within units, each of whose m values is
    compared with m - 1 others, and E that over all n values that can be compared (Krippendorff,
    Content Analysis, 3rd edition, 2013, chapter 12).

    Args:
        units: What each was called by whoever judged it; a unit with one judge tells nothing.

    Returns:
        None if there is nothing to compare, or all values are the same.
    """
    shared = [unit for unit in units if len(unit) > 1]
    values = Counter(value for unit in shared for value in unit)
    n = sum(values.values())
    expected = n * n - sum(count * count for count in values.values())
    if not expected:
        return None
    observed = sum(
        (len(unit) ** 2 - sum(c * c for c in Counter(unit).values())) / (len(unit) - 1)
        for unit in shared
    )
    return 1 - (n - 1) * observed / expected


def efforts(said: Sequence[HumanAnswer]) -> list[HumanEffort]:
    """What questions took people, by type and over all."""
    return [
        HumanEffort(
            name,
            len(part),
            sum(each.correct for each in part),
            _spread([each.seconds for each in part if each.seconds is not None]),
            _spread([each.turns for each in part]),
            _spread([each.manipulations for each in part]),
        )
        for name, part in _by_type(said)
    ]


def _by_type(said: Sequence[HumanAnswer]) -> list[tuple[str, list[HumanAnswer]]]:
    question_types = sorted({each.question_type for each in said})
    parts = [
        (question_type, [each for each in said if each.question_type == question_type])
        for question_type in question_types
    ]
    return [*parts, ("all", list(said))]


def _spread(values: Sequence[float]) -> tuple[float, float, float] | None:
    if not values:
        return None
    low, middle, high = (float(value) for value in np.percentile(values, [10, 50, 90]))
    return low, middle, high
