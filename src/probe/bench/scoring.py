"""Our scores in the harness's own table; all statistics are made of the records instead."""

from __future__ import annotations

import math
from collections import defaultdict
from statistics import fmean

from inspect_ai.scorer import Metric, SampleScore, Score, Scorer, Target, metric, scorer
from inspect_ai.solver import TaskState

RIGHT, WRONG, MISSING = "C", "I", "missing"
"""Values of a score; the first two are the harness's own for right and wrong."""

STORE = "probe"
"""Under which name an episode's worth is in a sample's store."""


@metric(scores="unreduced")
def accuracy_by_type(tasks: int, epochs: int) -> Metric:
    """Macro average and each type; no number while anything is missing.

    A sample that raised, or wasn't begun, has no score at all.

    Args:
        tasks: How many there should be.
        epochs: Runs of each.
    """

    def compute(scores: list[SampleScore]) -> dict[str, float | int]:
        runs: dict[str, list[float]] = defaultdict(list)
        question_types: dict[str, str] = {}
        for score in scores:
            name = str(score.sample_id)
            question_types[name] = str((score.sample_metadata or {}).get("kind", "unknown"))
            if score.score.value != MISSING:
                runs[name].append(float(score.score.value == RIGHT))
        missing = tasks * epochs - sum(min(len(each), epochs) for each in runs.values())
        whole = missing == 0 and len({len(each) for each in runs.values()}) == 1
        if whole:
            return {**_by_type(runs, question_types), "missing": missing}
        return {
            **dict.fromkeys(["macro", *sorted(set(question_types.values()))], math.nan),
            "missing": missing,
        }

    return compute


@scorer(metrics=[], name="probe")
def graded() -> Scorer:
    """The worth of an episode, as the table's process graded it."""

    async def score(state: TaskState, target: Target) -> Score:
        found = state.store.get(STORE)
        if not found:
            return Score(value=MISSING, explanation="The episode came to no end.")
        return Score.model_validate(found)

    return score


def _by_type(runs: dict[str, list[float]], question_types: dict[str, str]) -> dict[str, float]:
    """Mean of a task's runs, then of a type's tasks, then of the types."""
    tasks: dict[str, list[float]] = defaultdict(list)
    for name, values in runs.items():
        tasks[question_types[name]].append(fmean(values))
    means = {question_type: fmean(values) for question_type, values in sorted(tasks.items())}
    return {"macro": fmean(means.values()), **means}
