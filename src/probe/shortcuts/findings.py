"""What a rule or classifier achieved, and whether that is a leak. Statistics only."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from scipy import stats

from probe.scores.holm import holm
from probe.tasks.type_rules import rules_of

Verdict = Literal["below", "within noise", "above"]

LEVEL = 0.05
"""Chance that a set of tests of tasks without any leak calls one."""

POWER = 0.80

CEILING, PAIRED_CEILING = 0.20, 0.50
ALLOWANCE, PAIRED_ALLOWANCE = 0.03, 0.04


@dataclass(frozen=True)
class HitCount:
    """How often somebody who only looks was right.

    Attributes:
        question_type: Type, or type and part ("find, partly").
        by: Who: a rule's name, or a classifier's with its family ("logistic on areas").
        right, n: Tasks.
        ceiling: What guessing achieves at best.
        allowance: By how much that may be exceeded.
    """

    question_type: str
    by: str
    right: int
    n: int
    ceiling: float
    allowance: float

    @property
    def accuracy(self) -> float:
        """Share that was right."""
        return self.right / self.n

    @property
    def limit(self) -> float:
        """Accuracy up to which all is well."""
        return self.ceiling + self.allowance


@dataclass(frozen=True)
class Finding:
    """A tally, judged.

    Attributes:
        hits: What was achieved.
        low, high: 95 % interval of the accuracy (Wilson, JASA 22(158), 1927).
        p: Chance of as many right answers or more, were the ceiling the truth.
        adjusted: The same, corrected for all tests that were made (Holm).
        verdict: "above" is a leak: over the limit, and not by luck. "within noise" is over the
            limit, but may be luck; more tasks would tell.
    """

    hits: HitCount
    low: float
    high: float
    p: float
    adjusted: float
    verdict: Verdict


def allowed(question_type: str, *, letters_alone: bool = False) -> tuple[float, float]:
    """Ceiling and allowance of a type.

    Args:
        question_type: The type.
        letters_alone: For somebody who doesn't know what the options say: to them one letter is as
            good as another.
    """
    if rules_of(question_type).paired:
        return PAIRED_CEILING, PAIRED_ALLOWANCE
    naive = 0.0 if letters_alone else rules_of(question_type).naive
    return max(CEILING, naive), ALLOWANCE


def judge(tallies: Sequence[HitCount]) -> list[Finding]:
    """Judge all tests of one investigation together, in their order."""
    tests = [stats.binomtest(t.right, t.n, t.ceiling, alternative="greater") for t in tallies]
    chances = [float(test.pvalue) for test in tests]
    found: list[Finding] = []
    for hits, p, adjusted in zip(tallies, chances, holm(chances), strict=True):
        both = stats.binomtest(hits.right, hits.n).proportion_ci(method="wilson")
        verdict: Verdict = "below"
        if hits.accuracy > hits.limit:
            verdict = "above" if adjusted < LEVEL else "within noise"
        found.append(Finding(hits, float(both.low), float(both.high), p, adjusted, verdict))
    return found


def detectable(n: int, ceiling: float, allowance: float, tests: int) -> float:
    """True accuracy from which on n tasks show a leak four times in five, among so many tests.

    Exact for Holm's first step, which is what a single leak has to pass.

    Args:
        n: Tasks.
        ceiling: As in Tally.
        allowance: As in Tally.
        tests: All that are judged together.
    """
    by_luck = int(stats.binom.isf(LEVEL / tests, n, ceiling))
    most = max(by_luck, math.floor((ceiling + allowance) * n))
    return float(stats.beta.ppf(POWER, most + 1, n - most)) if most < n else 1.0
