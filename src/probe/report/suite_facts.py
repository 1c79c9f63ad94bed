"""What a suite consists of, and what its tasks' certificates say was measured."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from probe.scores.breakdown import Spread, spread
from probe.tasks.task import LETTERS, Task


@dataclass(frozen=True)
class TypeFacts:
    """One question type of a suite.

    Attributes:
        letters: How often each letter is right, A to E; None for letters that it doesn't offer.
        target_seen: Visible shares, at the start, of what decides the answer; None where nothing
            that is on the table does.
        measures: Each number of the type's rule, by name, over its tasks.
    """

    question_type: str
    tasks: int
    letters: tuple[int | None, ...]
    target_seen: Spread | None
    measures: tuple[tuple[str, Spread], ...]


def suite_facts(tasks: Iterable[Task]) -> list[TypeFacts]:
    """Count and measure a suite, by type in order of name."""
    question_types: dict[str, list[Task]] = {}
    for task in tasks:
        question_types.setdefault(task.question_type, []).append(task)
    return [
        _facts(question_type, question_types[question_type])
        for question_type in sorted(question_types)
    ]


def _facts(question_type: str, tasks: Sequence[Task]) -> TypeFacts:
    right = Counter(task.answer for task in tasks)
    offered = {option.letter for task in tasks for option in task.options}
    seen = [
        task.certificate.visibility[target].fraction
        for task in tasks
        for target in task.targets
        if target in task.certificate.visibility
    ]
    return TypeFacts(
        question_type=question_type,
        tasks=len(tasks),
        letters=tuple(right[letter] if letter in offered else None for letter in LETTERS),
        target_seen=spread(seen),
        measures=tuple(_measures(tasks)),
    )


def _measures(tasks: Sequence[Task]) -> Iterable[tuple[str, Spread]]:
    names = dict.fromkeys(name for task in tasks for name in task.certificate.measures)
    for name in names:
        certificates = [task.certificate.measures for task in tasks]
        found = spread([measures[name] for measures in certificates if name in measures])
        if found:
            yield name, found
