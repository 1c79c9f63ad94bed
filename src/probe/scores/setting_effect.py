"""Whether a setting does better than another over several agents and question types."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from probe.errors import ProbeError
from probe.scores.flips import FLIPS, flip_p
from probe.scores.units import Unit
from probe.types import Array

Both = Mapping[str, tuple[Sequence[Unit], Sequence[Unit]]]
"""By agent, its units in the one setting and in the other."""


class NoAgentInBothSettings(ProbeError):
    """Two settings can't be compared."""

    def __init__(self) -> None:
        super().__init__("No agent has a task in both settings. Run at least one agent in both.")


@dataclass(frozen=True)
class SettingEffect:
    """A setting against another, over agents and question types.

    Attributes:
        statistic: Cochran-Mantel-Haenszel, without continuity correction.
        p: From swapping the settings of whole tasks, for all agents and runs at once.
        plain_p: From the chi-squared distribution, which takes all episodes for independent.
        odds_ratio: Mantel and Haenszel's, over 1 if the first setting is better; None where it is
            no number.
        agents, tasks, episodes: In both settings together; tasks that an agent has in one setting
            only are left out for it.
        left_out: How often that was so.
    """

    statistic: float
    p: float
    plain_p: float
    odds_ratio: float | None
    agents: int
    tasks: int
    episodes: int
    left_out: int


@dataclass(frozen=True)
class _Counts:
    """Episodes by task and stratum (agent and type), each shape (tasks, strata)."""

    right: tuple[Array, Array]
    runs: tuple[Array, Array]


def setting_effect(both: Both, rng: np.random.Generator, draws: int = FLIPS) -> SettingEffect:
    """Test one setting against another, with strata of agent and question type.

    The statistic is Cochran's (Biometrics 10(4), 1954) as Mantel and Haenszel have it (JNCI 22(4),
    1959). The test's own p takes episodes for independent, but runs of a task resemble each other,
    and so do agents at a task. If the settings don't differ, a task's results could as well have
    come from the other setting, all of them together: that gives the p to rely on.

    Args:
        both: Results.
        rng: For the draws.
        draws: Of the test.

    Raises:
        NoAgentInBothSettings: Nothing can be compared.
    """
    counts = _count(both)
    found = _statistic(counts, np.zeros((1, len(counts.runs[0]))))
    tasks = len(counts.runs[0])
    return SettingEffect(
        statistic=float(found[0]),
        p=flip_p(lambda swaps: _statistic(counts, swaps), tasks, rng, draws),
        plain_p=float(stats.chi2.sf(found[0], df=1)),
        odds_ratio=_odds_ratio(counts),
        agents=sum(bool(_shared(*sides)) for sides in both.values()),
        tasks=tasks,
        episodes=int(counts.runs[0].sum() + counts.runs[1].sum()),
        left_out=sum(len({u.task for u in a} ^ {u.task for u in b}) for a, b in both.values()),
    )


def _shared(ones: Sequence[Unit], others: Sequence[Unit]) -> list[tuple[Unit, Unit]]:
    theirs = {unit.task: unit for unit in others}
    return [(unit, theirs[unit.task]) for unit in ones if unit.task in theirs]


def _count(both: Both) -> _Counts:
    pairs = [(agent, one, other) for agent in both for one, other in _shared(*both[agent])]
    if not pairs:
        raise NoAgentInBothSettings
    row = {task: i for i, task in enumerate(dict.fromkeys(one.task for _, one, _ in pairs))}
    keys = dict.fromkeys((agent, one.question_type) for agent, one, _ in pairs)
    column = {key: i for i, key in enumerate(keys)}
    right, runs = np.zeros((2, len(row), len(column))), np.zeros((2, len(row), len(column)))
    for agent, *sides in pairs:
        for setting, unit in enumerate(sides):
            place = setting, row[unit.task], column[agent, unit.question_type]
            right[place], runs[place] = sum(unit.runs), len(unit.runs)
    return _Counts((right[0], right[1]), (runs[0], runs[1]))


def _statistic(counts: _Counts, swaps: Array) -> Array:
    """Of each way to swap tasks, shape (m, tasks), the statistic, shape (m,).

    (sum(a - E a))^2 / sum(Var a), where a is the first setting's right answers in a stratum and its
    distribution is hypergeometric; 0 where nothing varies.
    """
    first = (1 - swaps) @ counts.right[0] + swaps @ counts.right[1]
    size = (1 - swaps) @ counts.runs[0] + swaps @ counts.runs[1]
    right = (counts.right[0] + counts.right[1]).sum(axis=0)
    total = (counts.runs[0] + counts.runs[1]).sum(axis=0)
    share = right / total
    excess = (first - size * share).sum(axis=1)
    variance = size * (total - size) * share * (1 - share) / (total - 1)
    spread = variance.sum(axis=1)
    return np.divide(excess**2, spread, out=np.zeros_like(excess), where=spread > 0)


def _odds_ratio(counts: _Counts) -> float | None:
    a, c = (right.sum(axis=0) for right in counts.right)
    n, m = (runs.sum(axis=0) for runs in counts.runs)
    against = float((c * (n - a) / (n + m)).sum())
    return float((a * (m - c) / (n + m)).sum()) / against if against else None
