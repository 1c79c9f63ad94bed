"""Rows to units: a task is one, however often it was run."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.errors import ProbeError
from probe.scores.row import Entrant, Row
from probe.types import Array

Strata = Mapping[str, Array]
"""By question type, a number for each of its tasks, shape (n,), n >= 1."""

Worth = Callable[[Row], bool]


class MissingRows(ProbeError):
    """A figure was asked of rows of which some are missing."""

    def __init__(self, row: Row) -> None:
        super().__init__(
            f"Run {row.run} of {row.agent} at {row.task} failed on our side ({row.fault}); it is "
            "neither right nor wrong. Run it again, or ask for the worst and the best case."
        )


class ContraryRows(ProbeError):
    """Two rows say what can't both be true."""

    def __init__(self, row: Row, reason: str) -> None:
        super().__init__(
            f"Run {row.run} of {row.agent} ({row.setting}) at {row.task}: {reason}. "
            "Take the rows of one suite, each run once."
        )


@dataclass(frozen=True)
class Unit:
    """One task, as one entrant fared at it.

    Attributes:
        task, question_type: Its id and its question type.
        runs: What each run was worth, 0 to 1; at least one.
    """

    task: str
    question_type: str
    runs: tuple[float, ...]

    @property
    def mean(self) -> float:
        """Mean over the runs."""
        return sum(self.runs) / len(self.runs)


def is_correct(row: Row) -> bool:
    """The answer counts."""
    return row.correct


def units_of(rows: Iterable[Row], worth: Worth = is_correct) -> list[Unit]:
    """Gather the rows of one entrant into tasks, in the order in which these first appear.

    Args:
        rows: Of one agent in one setting, none missing.
        worth: What counts as right.

    Raises:
        MissingRows: One of them is a failure of ours.
        ContraryRows: They are of several entrants, a run is there twice, or a task has two types.
    """
    first: dict[str, Row] = {}
    runs: dict[str, dict[int, float]] = {}
    entrant: Entrant | None = None
    for row in rows:
        entrant = entrant or row.entrant
        if row.missing:
            raise MissingRows(row)
        if row.entrant != entrant:
            raise ContraryRows(row, f"others are by {entrant.agent} ({entrant.setting})")
        if first.setdefault(row.task, row).question_type != row.question_type:
            raise ContraryRows(row, "the task has two types")
        if row.run in runs.setdefault(row.task, {}):
            raise ContraryRows(row, "it is there twice")
        runs[row.task][row.run] = float(worth(row))
    return [Unit(task, first[task].question_type, tuple(runs[task].values())) for task in first]


def strata_of(units: Sequence[Unit], *, pool: bool = False) -> dict[str, Array]:
    """Means of tasks by question type, in order of the types' names; pooled, in one stratum."""
    question_types = sorted({unit.question_type for unit in units})
    strata = {
        question_type: np.array([u.mean for u in units if u.question_type == question_type])
        for question_type in question_types
    }
    return {"": np.concatenate(list(strata.values()))} if pool and strata else strata


def by_entrant(rows: Iterable[Row]) -> dict[Entrant, list[Row]]:
    """Rows by who answered, in order of agent and setting."""
    found: dict[Entrant, list[Row]] = {}
    for row in rows:
        found.setdefault(row.entrant, []).append(row)
    return dict(sorted(found.items()))
