"""How far an estimate may be off, tasks being a sample of all tasks that could have been made."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from probe.errors import ProbeError
from probe.scene.seeds import generator
from probe.scores.estimates import macro
from probe.scores.units import Strata, Unit
from probe.types import Array

LEVEL = 0.95
DRAWS = 10_000
SHARES, DIFFERENCES = (0.0, 1.0), (-1.0, 1.0)
"""Between which limits each task's number lies."""


class SeveralRuns(ProbeError):
    """An interval for single runs was asked of tasks that were run several times."""

    def __init__(self, unit: Unit) -> None:
        super().__init__(
            f"{unit.task} was run {len(unit.runs)} times, and runs of a task resemble each other. "
            "Use the bootstrap or the stratified t interval."
        )


@dataclass(frozen=True)
class Interval:
    """A confidence interval."""

    low: float
    high: float


def bootstrap(
    strata: Strata,
    seed: int,
    *,
    limits: tuple[float, float] = SHARES,
    draws: int = DRAWS,
    level: float = LEVEL,
) -> Interval:
    """Percentile bootstrap of the macro average that draws tasks within each type.

    Efron's bootstrap (Ann. Statist. 7(1), 1979). The mean of n drawn with replacement varies by
    (n - 1) / n of what it should; deviations are widened by sqrt(n / (n - 1)), type by type
    (Davison and Hinkley, Bootstrap Methods and their Application, 1997, section 3.2). Types whose
    tasks are all alike add what _unseen says.

    Args:
        strata: Numbers of tasks by type.
        seed: Of the draws.
        limits: Between which each task's number lies.
        draws: How many.
        level: Share of suites whose interval should hold the truth.
    """
    total = np.zeros(draws)
    for question_type, values in strata.items():
        total += deviations(values, generator(seed, "bootstrap", question_type), draws)
    tail = (1 - level) / 2
    low, high = np.quantile(total / len(strata), [tail, 1 - tail])
    return _around(strata, max(0.0, -float(low)), max(0.0, float(high)), limits, level)


def deviations(values: Array, rng: np.random.Generator, draws: int = DRAWS) -> Array:
    """What means of tasks drawn again deviate by, widened as bootstrap() says.

    Args:
        values: Of each task, shape (n,), or of several things at each, shape (n, k).
        rng: For the draws; the same gives the same draws for all.
        draws: How many.

    Returns:
        Shape (draws,) or (draws, k).
    """
    n = len(values)
    counts = rng.multinomial(n, np.full(n, 1 / n), size=draws)
    return math.sqrt(n / max(n - 1, 1)) * (counts @ values / n - values.mean(axis=0))


def student(
    strata: Strata, *, limits: tuple[float, float] = SHARES, level: float = LEVEL
) -> Interval:
    """Stratified t interval of the macro average; see bootstrap for the arguments.

    The standard error of a stratified mean (Cochran, Sampling Techniques, 1977, chapter 5) with
    Satterthwaite's degrees of freedom (Biometrics Bulletin 2(6), 1946).
    """
    error, freedom = standard_error(strata)
    margin = float(stats.t.isf((1 - level) / 2, freedom)) * error if error else 0.0
    return _around(strata, margin, margin, limits, level)


def standard_error(strata: Strata) -> tuple[float, float]:
    """Standard error of the macro average, and its degrees of freedom.

    Types with a single task have no variance to go by and add nothing; if all are so, or no type's
    tasks differ, both are 0.
    """
    varying = [values for values in strata.values() if len(values) > 1]
    parts = [float(values.var(ddof=1)) / len(values) / len(strata) ** 2 for values in varying]
    variance = sum(parts)
    if variance == 0:
        return 0.0, 0.0
    freedoms = [part**2 / (len(values) - 1) for part, values in zip(parts, varying, strict=True)]
    return math.sqrt(variance), variance**2 / sum(freedoms)


def wilson(units: Sequence[Unit], level: float = LEVEL) -> Interval:
    """Score interval for a share of single runs (Wilson, JASA 22(158), 1927).

    Raises:
        SeveralRuns: A task was run more than once.
    """
    for unit in units:
        if len(unit.runs) > 1:
            raise SeveralRuns(unit)
    right = sum(unit.mean == 1 for unit in units)
    found = stats.binomtest(right, len(units)).proportion_ci(level, method="wilson")
    return Interval(float(found.low), float(found.high))


def _around(
    strata: Strata, below: float, above: float, limits: tuple[float, float], level: float
) -> Interval:
    """Margins of the types that vary, joined with those of the types that don't.

    Squares add up, as in MOVER (Zou and Donner, Stat. Med. 27(10), 2008).
    """
    centre, share = macro(strata), 1 / len(strata)
    alike = [values for values in strata.values() if np.ptp(values) == 0]
    less = [share * _unseen(values, level) * (values[0] - limits[0]) for values in alike]
    more = [share * _unseen(values, level) * (limits[1] - values[0]) for values in alike]
    low, high = centre - math.hypot(below, *less), centre + math.hypot(above, *more)
    return Interval(max(low, limits[0]), min(high, limits[1]))


def _unseen(values: Array, level: float) -> float:
    """Largest share of tasks that may differ where all n that were seen are alike.

    Wilson's upper limit for 0 of n: z^2 / (n + z^2). For tasks all right or all wrong the interval
    becomes Wilson's.
    """
    squared = float(stats.norm.isf((1 - level) / 2)) ** 2
    return squared / (len(values) + squared)
