"""Which differences a suite can show at all."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from scipy import stats

from probe.scores.intervals import LEVEL

POWER = 0.80


def detectable_gap(
    error: float, freedom: float, *, power: float = POWER, level: float = LEVEL
) -> float:
    """Smallest true difference that a two-sided test finds with this power.

    (t[1 - alpha / 2] + t[power]) standard errors (Bloom, Evaluation Review 19(5), 1995).

    Args:
        error: Standard error of the difference.
        freedom: Its degrees of freedom.
        power: Share of suites in which it is found.
        level: 1 minus the share of suites in which a difference of 0 is found.
    """
    tails = float(stats.t.isf((1 - level) / 2, freedom)), float(stats.t.ppf(power, freedom))
    return sum(tails) * error


@dataclass(frozen=True)
class PowerAssumptions:
    """What is assumed of two agents before either has run.

    Attributes:
        accuracy: Share of right runs, of both.
        icc: Correlation of runs of an agent at a task.
        alike: Correlation of the two agents' chances at a task.
        runs: Of each task.
    """

    accuracy: float
    icc: float
    alike: float
    runs: int


def expected_error(sizes: Mapping[str, int], outlook: PowerAssumptions) -> tuple[float, float]:
    """Standard error of a difference of macro averages, and its degrees of freedom.

    Each task's difference has the variance 2 s (icc (1 - alike) + (1 - icc) / runs), where s is
    accuracy (1 - accuracy): tasks on which agents differ, and the luck of runs.

    Args:
        sizes: Number of tasks by question type.
        outlook: What is assumed.
    """
    spread = outlook.accuracy * (1 - outlook.accuracy)
    luck = (1 - outlook.icc) / outlook.runs
    variance = 2 * spread * (outlook.icc * (1 - outlook.alike) + luck)
    parts = [variance / n / len(sizes) ** 2 for n in sizes.values()]
    freedoms = [part**2 / (n - 1) for part, n in zip(parts, sizes.values(), strict=True)]
    return math.sqrt(sum(parts)), sum(parts) ** 2 / sum(freedoms)
