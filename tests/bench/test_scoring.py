"""Our number in the harness's own table: none while an episode is missing, however it went."""

from __future__ import annotations

import math
from typing import Any

import pytest
from inspect_ai.scorer import SampleScore, Score

from probe.bench.scoring import MISSING, RIGHT, WRONG, accuracy_by_type


def score(task: str, value: str) -> SampleScore:
    kind = task.split("-")[0]
    return SampleScore(score=Score(value=value), sample_id=task, sample_metadata={"kind": kind})


def figures(scores: list[SampleScore], tasks: int, epochs: int) -> dict[str, float]:
    metric: Any = accuracy_by_type(tasks, epochs)
    return metric(scores)


EPOCH = [score("find-1", RIGHT), score("find-2", WRONG), score("size-1", RIGHT)]


def test_types_weigh_alike_and_so_do_runs():
    second = [score("find-1", RIGHT), score("find-2", RIGHT), score("size-1", WRONG)]
    # Find (1 + 1/2) / 2, Size 1/2.
    wanted = {"macro": 0.625, "find": 0.75, "size": 0.5, "missing": 0}
    assert figures([*EPOCH, *second], 3, 2) == wanted


@pytest.mark.parametrize(
    ("scores", "missing"),
    [
        ([], 6),
        (EPOCH, 3),
        ([*EPOCH, *EPOCH[1:]], 1),
        ([*EPOCH, score("find-1", MISSING), *EPOCH[1:]], 1),
        ([*EPOCH[1:], *EPOCH[1:]], 2),
    ],
)
def test_what_raised_or_was_never_begun_is_missing(scores, missing):
    found = figures(scores, 3, 2)
    assert found["missing"] == missing
    assert {name for name in found if math.isnan(found[name])} == set(found) - {"missing"}
    assert "macro" in found


def test_more_epochs_than_planned_make_up_for_none():
    found = figures([*EPOCH, *EPOCH[1:]], 3, 1)
    assert math.isnan(found["macro"]) and found["missing"] == 0
    assert figures([*EPOCH, *EPOCH], 3, 1)["macro"] == 0.75
    assert figures([*EPOCH[1:], *EPOCH[1:]], 3, 1)["missing"] == 1
