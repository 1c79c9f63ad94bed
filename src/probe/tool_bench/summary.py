"""Trials to rates: with n, intervals that respect scenes, causes and classes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import binomtest

from probe.tool_bench.trial import Tool, ToolTrial

_DRAWS = 4000


@dataclass(frozen=True)
class Rate:
    """How often something held.

    Attributes:
        name: What.
        held, n: Times, of so many.
        low, high: 95 % interval of the share: percentiles of the bootstrap that draws whole
            scenes, which trials of one scene share.
        wilson: 95 % score interval, as if all trials were independent (Wilson, JASA 22, 1927).
    """

    name: str
    held: int
    n: int
    low: float
    high: float
    wilson: tuple[float, float]

    @property
    def share(self) -> float:
        return self.held / self.n


@dataclass(frozen=True)
class Summary:
    """What a tool did, of at least one trial.

    Attributes:
        rates: What the tool is judged by.
        causes: Outcomes and how often, the most frequent first.
        groups: What is told apart, and for each of its classes how many were good, and of how many.
        seconds: Median and 95th percentile of CPU seconds of planning, execution and both.
    """

    tool: Tool
    rates: tuple[Rate, ...]
    causes: tuple[tuple[str, int], ...]
    groups: tuple[tuple[str, tuple[tuple[str, int, int], ...]], ...]
    seconds: tuple[tuple[str, float, float], ...]


def summarise(tool: Tool, trials: Sequence[ToolTrial]) -> Summary:
    """All figures of a tool's trials."""
    judged: dict[str, Callable[[ToolTrial], bool]]
    if tool == "grasp":
        judged = {"in the basket": lambda t: t.good, "truthful": lambda t: t.truthful}
    else:
        judged = {"executed": lambda t: t.executed, "effective": lambda t: t.good}
    judged |= {
        "another object moved over 3 cm": lambda t: t.others_moved > 0,
        "another object left the table": lambda t: t.others_lost > 0,
    }
    times: dict[str, Callable[[ToolTrial], float]] = {
        "planning": lambda t: t.planning,
        "execution": lambda t: t.execution,
        "whole attempt": lambda t: t.planning + t.execution,
    }
    return Summary(
        tool,
        tuple(rate(name, trials, holds) for name, holds in judged.items()),
        tuple(Counter(trial.cause for trial in trials).most_common()),
        _groups(trials),
        tuple(_seconds(name, [value(t) for t in trials]) for name, value in times.items()),
    )


def rate(name: str, trials: Sequence[ToolTrial], holds: Callable[[ToolTrial], bool]) -> Rate:
    """How often something held, with its intervals."""
    held = np.array([holds(trial) for trial in trials])
    interval = binomtest(int(held.sum()), len(held)).proportion_ci(method="wilson")
    low, high = _by_scene(np.array([trial.seed for trial in trials]), held)
    wilson = (float(interval.low), float(interval.high))
    return Rate(name, int(held.sum()), len(held), low, high, wilson)


def drawn_anew(trials: Sequence[ToolTrial]) -> tuple[int, int]:
    """How many tables had to be drawn again to be at rest, and of how many that is known."""
    known = {trial.seed: trial.restless for trial in trials if trial.restless is not None}
    return sum(restless > 0 for restless in known.values()), len(known)


def _by_scene(seeds: np.ndarray, held: np.ndarray) -> tuple[float, float]:
    scenes, of = np.unique(seeds, return_inverse=True)
    wins, sizes = np.bincount(of, held), np.bincount(of)
    draws = np.random.default_rng(0).integers(len(scenes), size=(_DRAWS, len(scenes)))
    shares = wins[draws].sum(axis=1) / sizes[draws].sum(axis=1)
    low, high = np.percentile(shares, [2.5, 97.5])
    return float(low), float(high)


def _groups(
    trials: Sequence[ToolTrial],
) -> tuple[tuple[str, tuple[tuple[str, int, int], ...]], ...]:
    counts: dict[str, dict[str, list[bool]]] = {}
    for trial in trials:
        for aspect, label in trial.groups:
            counts.setdefault(aspect, {}).setdefault(label, []).append(trial.good)
    return tuple(
        (aspect, tuple((label, sum(some), len(some)) for label, some in sorted(classes.items())))
        for aspect, classes in counts.items()
    )


def _seconds(name: str, values: Sequence[float]) -> tuple[str, float, float]:
    return name, float(np.median(values)), float(np.percentile(values, 95))
