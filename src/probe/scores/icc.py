"""How much runs of a task resemble each other."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from probe.scores.units import Unit


def icc(units: Iterable[Unit]) -> float | None:
    """Intraclass correlation of runs within question types, one-way random effects.

    That is ICC(1, 1) of Shrout and Fleiss (Psychol. Bull. 86(2), 1979), with mean squares pooled
    over types. Where tasks were run unequally often, the mean number of runs is the one that keeps
    the estimate of variance unbiased (Donner, Int. Stat. Rev. 54(1), 1986). It may be a little
    below 0 where runs are unrelated.

    Returns:
        None if no task was run twice, no type has two tasks, or nothing varies.
    """
    question_types: dict[str, list[Sequence[float]]] = {}
    for unit in units:
        question_types.setdefault(unit.question_type, []).append(unit.runs)
    between = within = repeats = 0.0
    freedom = spare = 0
    for tasks in question_types.values():
        sizes = np.array([len(runs) for runs in tasks])
        means = np.array([np.mean(runs) for runs in tasks])
        middle = float(sizes @ means) / int(sizes.sum())
        between += float(sizes @ (means - middle) ** 2)
        within += sum(len(runs) * float(np.var(runs)) for runs in tasks)
        freedom += len(tasks) - 1
        spare += int(sizes.sum()) - len(tasks)
        repeats += float(sizes.sum() - (sizes**2).sum() / sizes.sum())
    if not freedom or not spare or between + within == 0:
        return None
    return _from_squares(between / freedom, within / spare, repeats / freedom)


def _from_squares(between: float, within: float, runs: float) -> float:
    return (between - within) / (between + (runs - 1) * within)
