"""Which types of tasks a library has the things for, before anything is built. No physics.

It asks the generators themselves who would play; what then lies, tips or shows is not looked at.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.result import Rejected
from probe.generation.salt import Salt
from probe.generation.task_generator import generator_of
from probe.scene.seeds import generator
from probe.tasks.task import NEWEST_RULES, QUESTION_TYPES, QuestionType, RulesVersion

TRIES = 40
"""Castings of a place that must all fail before it is called impossible; see also LONGER."""

LONGER = 5 * TRIES
"""The same where others of its type can be cast: of Budgeted's castings one in twelve succeeds."""


@dataclass(frozen=True)
class Feasibility:
    """Whether there are the things for a type.

    Attributes:
        question_type: The type.
        places: Those asked for.
        hopeless: Those for which nobody could be cast.
        missing: Why, for people: what the castings failed by, the most frequent first.
    """

    question_type: QuestionType
    places: tuple[TaskSlot, ...]
    hopeless: tuple[TaskSlot, ...]
    missing: tuple[str, ...]

    @property
    def needs(self) -> str:
        """What the type takes."""
        return generator_of(self.question_type).needs


def possibilities(
    places: Sequence[TaskSlot],
    library: Library,
    salt: Salt | None = None,
    rules: RulesVersion = NEWEST_RULES,
    made: Collection[TaskSlot] = (),
) -> tuple[Feasibility, ...]:
    """What can be made of a library, type by type.

    Args:
        places: The tasks that are asked for.
        library: The things.
        salt: Of a private suite.
        rules: The version of the rules that the tasks are to be made by.
        made: Those of the places that have a task: they can be cast.
    """

    def attempt(place: TaskSlot, number: int) -> Attempt:
        return Attempt(place, number, salt, rules=rules)

    question_types: list[QuestionType] = [
        question_type
        for question_type in QUESTION_TYPES
        if any(place.question_type == question_type for place in places)
    ]
    return tuple(
        _of_type(
            question_type,
            tuple(p for p in places if p.question_type == question_type),
            library,
            attempt,
            made,
        )
        for question_type in question_types
    )


def _of_type(
    question_type: QuestionType,
    places: tuple[TaskSlot, ...],
    library: Library,
    attempt: Callable[[TaskSlot, int], Attempt],
    made: Collection[TaskSlot],
) -> Feasibility:
    failures = Counter[str]()
    lacking = tuple(place for place in places if place not in made)
    hopeless = _uncast(lacking, range(TRIES), library, attempt, failures)
    if len(hopeless) < len(places):
        failures.clear()
        hopeless = _uncast(hopeless, range(TRIES, LONGER), library, attempt, failures)
    return Feasibility(
        question_type, places, hopeless, tuple(reason for reason, _ in failures.most_common())
    )


def _uncast(
    places: tuple[TaskSlot, ...],
    numbers: range,
    library: Library,
    attempt: Callable[[TaskSlot, int], Attempt],
    failures: Counter[str],
) -> tuple[TaskSlot, ...]:
    """The places for which none of some numbered castings succeeds."""
    return tuple(
        place
        for place in places
        if not _can_be_selected(place, numbers, library, attempt, failures)
    )


def _can_be_selected(
    place: TaskSlot,
    numbers: range,
    library: Library,
    attempt: Callable[[TaskSlot, int], Attempt],
    failures: Counter[str],
) -> bool:
    """Whether anybody can play; what went wrong is counted if nobody can."""
    mine = Counter[str]()
    for number in numbers:
        made = attempt(place, number)
        rng = generator(made.seed, place.question_type, "possible")
        try:
            generator_of(place.question_type).select(library, made.plan, rng)
        except Rejected as failure:
            mine[str(failure)] += 1
        else:
            return True
    failures.update(mine)
    return False
