"""Two entrants on the tasks that both were given: difference, interval and test."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import pydantic

from probe.errors import ProbeError
from probe.scene.seeds import generator
from probe.scores.estimates import macro
from probe.scores.flips import FLIPS, sign_flip_p
from probe.scores.holm import holm
from probe.scores.intervals import DIFFERENCES, LEVEL, Interval, bootstrap, standard_error, student
from probe.scores.power import detectable_gap
from probe.scores.row import Entrant
from probe.scores.units import Strata, Unit, strata_of

Results = Mapping[Entrant, Sequence[Unit]]


class NothingShared(ProbeError):
    """Two entrants have no task in common."""

    def __init__(self, first: Entrant, second: Entrant) -> None:
        super().__init__(
            f"{first.agent} ({first.setting}) and {second.agent} ({second.setting}) share no task. "
            "Compare those that ran the same suite."
        )


@dataclass(frozen=True)
class Pair:
    """How two entrants differ on shared tasks.

    Attributes:
        first, second: Who.
        difference: Macro average of the first minus that of the second.
        question_types: The same by question type.
        student, bootstrap: 95 % intervals of the difference, by the t distribution and by drawing
            tasks.
        p: Of the sign-flip test within types.
        adjusted: p after Holm's correction for the family.
        tie: Not rejected after it: "not shown to differ", which is not "equal".
        tasks: Shared ones.
        left_out: Tasks that only one of them has results of.
        detectable: The difference that these tasks show in 80 % of suites; None where nothing
            varies.
    """

    first: Entrant
    second: Entrant
    difference: float
    question_types: Annotated[Mapping[str, float], pydantic.Field(serialization_alias="kinds")]
    student: Interval
    bootstrap: Interval
    p: float
    adjusted: float
    tie: bool
    tasks: int
    left_out: int
    detectable: float | None


@dataclass(frozen=True)
class _Difference:
    first: Entrant
    second: Entrant
    strata: Strata
    tasks: int
    left_out: int


def share_tasks(results: Results, pair: tuple[Entrant, Entrant]) -> bool:
    """Whether there is a task that both were given."""
    one, other = ({unit.task for unit in results[entrant]} for entrant in pair)
    return not one.isdisjoint(other)


def family(
    results: Results,
    pairs: Iterable[tuple[Entrant, Entrant]],
    seed: int,
    *,
    draws: int = FLIPS,
    level: float = LEVEL,
) -> list[Pair]:
    """Compare pairs that were declared beforehand, with Holm's correction for their number.

    Args:
        results: Units of each entrant.
        pairs: Who is compared with whom.
        seed: Of the draws.
        draws: Of each test.
        level: 1 minus the chance of any false rejection in the family.

    Raises:
        NothingShared: A pair has no task in common.
    """
    found = [_difference(first, second, results) for first, second in pairs]
    chances = [
        no_difference_p(it.strata, generator(seed, "pair", *it.first, *it.second), draws)
        for it in found
    ]
    adjusted = holm(chances)
    return [
        _pair(each, p, high, seed, level)
        for each, p, high in zip(found, chances, adjusted, strict=True)
    ]


def _difference(first: Entrant, second: Entrant, results: Results) -> _Difference:
    mine = {unit.task: unit for unit in results[first]}
    theirs = {unit.task: unit for unit in results[second]}
    shared = [(mine[task], theirs[task]) for task in mine if task in theirs]
    if not shared:
        raise NothingShared(first, second)
    units = [Unit(one.task, one.question_type, (one.mean - other.mean,)) for one, other in shared]
    return _Difference(
        first, second, strata_of(units), len(shared), len(mine.keys() ^ theirs.keys())
    )


def no_difference_p(strata: Strata, rng: np.random.Generator, draws: int = FLIPS) -> float:
    """Two-sided p of the macro average of differences, by flipping signs within types.

    Args:
        strata: Differences of tasks by type.
        rng: For the draws.
        draws: How many.
    """
    weighted = [values / len(values) / len(strata) for values in strata.values()]
    return sign_flip_p(np.concatenate(weighted), rng, draws)


def _pair(difference: _Difference, p: float, adjusted: float, seed: int, level: float) -> Pair:
    strata = difference.strata
    error, freedom = standard_error(strata)
    return Pair(
        first=difference.first,
        second=difference.second,
        difference=macro(strata),
        question_types={
            question_type: float(values.mean()) for question_type, values in strata.items()
        },
        student=student(strata, limits=DIFFERENCES, level=level),
        bootstrap=bootstrap(strata, seed, limits=DIFFERENCES, level=level),
        p=p,
        adjusted=adjusted,
        tie=adjusted > 1 - level,
        tasks=difference.tasks,
        left_out=difference.left_out,
        detectable=detectable_gap(error, freedom) if error else None,
    )
