"""What wasn't run, or failed on our side: named, counted, and bounded. Never left out."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from typing import Annotated

import pydantic

from probe.scores.estimates import macro
from probe.scores.roster import Roster, task_of
from probe.scores.row import Entrant, Row
from probe.scores.units import ContraryRows, Unit, Worth, is_correct, strata_of, units_of


@dataclass(frozen=True)
class Gap:
    """A run of a task that gave no result, and why."""

    task: str
    question_type: Annotated[str, pydantic.Field(serialization_alias="kind")]
    run: int
    reason: str


@dataclass(frozen=True)
class Absent:
    """An entrant that was ordered and of which there is no row: all of it is missing.

    Attributes:
        entrant: Who it is.
        ordered: Runs of each task that it was to have.
        tools: Version of the tools that it was to have.
    """

    entrant: Entrant
    ordered: int
    tools: int


@dataclass(frozen=True)
class Headline:
    """An average over types or, pooled, over tasks; or the reason why there is none.

    Attributes:
        value: None while rows are missing.
        worst, best: The same if all that is missing were wrong, or right.
        rows: How many there should be.
        missing: How many of them are missing.
    """

    value: float | None
    worst: float
    best: float
    rows: int
    missing: int


def settled(rows: Iterable[Row]) -> list[Row]:
    """Rows of which each run has one: a run that failed on our side gives way to its repetition.

    Raises:
        ContraryRows: A run has two results.
    """
    kept: dict[tuple[Entrant, str, int], Row] = {}
    for row in rows:
        key = row.entrant, row.task, row.run
        earlier = kept.get(key)
        if earlier is not None and not earlier.missing and not row.missing:
            raise ContraryRows(row, "it has two results")
        if earlier is None or earlier.missing:
            kept[key] = row
    return list(kept.values())


def runs_of(rows: Iterable[Row]) -> set[int]:
    """Runs that each task of an entrant should have: those ordered, and those any task has."""
    found = set[int]()
    for row in rows:
        found |= {row.run, *range(row.ordered or 0)}
    return found


def gaps_of(rows: Sequence[Row], roster: Roster, runs: Collection[int] = ()) -> list[Gap]:
    """What one entrant lacks: each task of the roster should have each run of runs_of.

    Args:
        rows: Of the entrant.
        roster: Tasks.
        runs: Further runs that there should be, since tasks elsewhere have them.

    Raises:
        ContraryRows: A row's task isn't on the roster, or is another one there.
    """
    for row in rows:
        if roster.get(row.task) != task_of(row):
            raise ContraryRows(row, "the task isn't of this suite")
    there = {(row.task, row.run): row for row in rows}
    wanted = sorted(runs_of(rows) | set(runs)) or [0]
    found = list[Gap]()
    for task, listed in roster.items():
        for run in wanted:
            row = there.get((task, run))
            if row is None or row.fault is not None:
                reason = "never run" if row is None else str(row.fault)
                found.append(Gap(task, listed.question_type, run, reason))
    return found


def present(rows: Iterable[Row]) -> list[Row]:
    """Rows that aren't missing; whoever takes these says how many are."""
    return [row for row in rows if not row.missing]


def filled(
    rows: Sequence[Row], gaps: Sequence[Gap], value: float, worth: Worth = is_correct
) -> list[Unit]:
    """One entrant's units, with all that is missing given this value."""
    runs: dict[tuple[str, str], list[float]] = {}
    for unit in units_of(present(rows), worth):
        runs[unit.task, unit.question_type] = list(unit.runs)
    for gap in gaps:
        runs.setdefault((gap.task, gap.question_type), []).append(value)
    return [
        Unit(task, question_type, tuple(values)) for (task, question_type), values in runs.items()
    ]


def headline(
    rows: Sequence[Row],
    roster: Roster,
    worth: Worth = is_correct,
    runs: Collection[int] = (),
    *,
    pool: bool = False,
) -> Headline:
    """One entrant's macro average; refused while anything of it is missing.

    Args:
        rows: Of the entrant.
        roster: Tasks.
        worth: What counts as right.
        runs: As in gaps_of.
        pool: Average tasks instead, whatever their type.

    Raises:
        ContraryRows: A run is there twice, or a task isn't on the roster.
    """
    gaps = gaps_of(rows, roster, runs)
    worst, best = (
        macro(strata_of(filled(rows, gaps, value, worth), pool=pool)) for value in (0.0, 1.0)
    )
    whole = len(present(rows)) + len(gaps)
    return Headline(None if gaps else worst, worst, best, whole, len(gaps))
