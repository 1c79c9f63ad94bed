"""What agents did on the way: outcomes with and without manipulation, budgets, time and cost."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import pydantic

from probe.scores.row import Row


@dataclass(frozen=True)
class Outcomes:
    """Episodes of a question type, by whether a manipulation was used and the answer was right.

    Attributes:
        missing: Failures of ours, in none of the four.
    """

    question_type: Annotated[str, pydantic.Field(serialization_alias="kind")]
    used_right: int
    used_wrong: int
    unused_right: int
    unused_wrong: int
    missing: int


@dataclass(frozen=True)
class Spread:
    """How some numbers are spread.

    Attributes:
        n: How many are known; the rest says nothing of others.
        p10, p90: Percentiles, interpolated linearly.
    """

    n: int
    mean: float
    median: float
    p10: float
    p90: float
    total: float


@dataclass(frozen=True)
class Effort:
    """What episodes took; a spread is None where no episode says.

    Attributes:
        episodes: Those that weren't ended by a failure of ours; all else is about them.
        turns_spent, manipulations_spent: Episodes that met the limit.
        cost: US dollars.
    """

    episodes: int
    turns: Spread | None
    manipulations: Spread | None
    perceptions: Spread | None
    turns_spent: int
    manipulations_spent: int
    seconds_agent: Spread | None
    seconds_tools: Spread | None
    tokens_in: Spread | None
    tokens_out: Spread | None
    cost: Spread | None


@dataclass(frozen=True)
class Execution:
    """How Reduce's orders were carried out: means over the episodes that say.

    Attributes:
        episodes: Those that say anything.
        precision, attempts_a_removal: None if nothing was removed in any.
        strict: Share that is both right and exact.
    """

    episodes: int
    precision: float | None
    recall: float | None
    exact: float
    attempts_a_removal: float | None
    others_disturbed: float
    strict: float


def outcomes(rows: Iterable[Row]) -> list[Outcomes]:
    """Count one entrant's episodes, by type in order of name."""
    question_types: dict[str, list[Row]] = {}
    for row in rows:
        question_types.setdefault(row.question_type, []).append(row)
    return [
        _outcomes(question_type, some) for question_type, some in sorted(question_types.items())
    ]


def _outcomes(question_type: str, rows: Sequence[Row]) -> Outcomes:
    done = [(row.manipulated, row.correct) for row in rows if not row.missing]
    return Outcomes(
        question_type=question_type,
        used_right=done.count((True, True)),
        used_wrong=done.count((True, False)),
        unused_right=done.count((False, True)),
        unused_wrong=done.count((False, False)),
        missing=len(rows) - len(done),
    )


def effort(rows: Iterable[Row]) -> Effort:
    """What one entrant's episodes took."""
    done = [row for row in rows if not row.missing]
    return Effort(
        episodes=len(done),
        turns=spread([row.turns for row in done]),
        manipulations=spread([row.manipulations for row in done]),
        perceptions=spread([row.perceptions for row in done]),
        turns_spent=sum(row.turns_spent for row in done),
        manipulations_spent=sum(row.manipulations_spent for row in done),
        seconds_agent=spread([row.seconds_agent for row in done]),
        seconds_tools=spread([row.seconds_tools for row in done]),
        tokens_in=spread([row.tokens_in for row in done]),
        tokens_out=spread([row.tokens_out for row in done]),
        cost=spread([row.cost for row in done]),
    )


def spread(values: Sequence[float | None]) -> Spread | None:
    """Of the values that are known; None if none is."""
    known = np.array([value for value in values if value is not None], dtype=float)
    if not len(known):
        return None
    p10, median, p90 = (float(p) for p in np.percentile(known, [10, 50, 90]))
    return Spread(len(known), float(known.mean()), median, p10, p90, float(known.sum()))


def execution(rows: Iterable[Row]) -> Execution | None:
    """Of one entrant's episodes of Reduce; None if there are none."""
    done = [row for row in rows if row.exact is not None and not row.missing]
    if not done:
        return None
    return Execution(
        episodes=len(done),
        precision=_mean([row.precision for row in done]),
        recall=_mean([row.recall for row in done]),
        exact=float(np.mean([bool(row.exact) for row in done])),
        attempts_a_removal=_mean([row.attempts_a_removal for row in done]),
        others_disturbed=float(np.mean([row.others_disturbed or 0 for row in done])),
        strict=float(np.mean([bool(row.strict) for row in done])),
    )


def _mean(values: Sequence[float | None]) -> float | None:
    found = spread(values)
    return found and found.mean
