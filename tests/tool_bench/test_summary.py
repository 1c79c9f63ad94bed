"""Trials to figures: shares, intervals, causes, classes."""

from __future__ import annotations

import numpy as np
import pytest

from probe.tool_bench.summary import rate, summarise
from probe.tool_bench.trial import ToolTrial, band

PLAIN = ToolTrial(
    tool="grasp",
    seed=1,
    instance=2,
    object_id="proc_lime",
    direction=None,
    distance=None,
    status="removed",
    good=True,
    executed=True,
    truthful=True,
    others_moved=0,
    others_lost=0,
    ratio=None,
    tries=1,
    width=0.05,
    share=0.97,
    mass=0.1,
    longest=0.06,
    planning=0.4,
    execution=0.3,
)


def trial(**changes) -> ToolTrial:
    return PLAIN.model_copy(update=changes)


def test_rates_count_what_they_name() -> None:
    some = [trial(seed=k, others_moved=k % 3, good=k % 4 > 0) for k in range(40)]
    figures = {r.name: (r.held, r.n) for r in summarise("grasp", some).rates}
    assert figures["in the basket"] == (30, 40)
    assert figures["another object moved over 3 cm"] == (26, 40)
    assert figures["another object left the table"] == (0, 40)


def test_the_wilson_interval_is_the_known_one() -> None:
    some = [trial(seed=k, good=k < 85) for k in range(100)]
    # R. Newcombe, "Two-sided confidence intervals for the single proportion" (1998), formula 3.
    assert rate("x", some, lambda t: t.good).wilson == pytest.approx((0.7672, 0.9069), abs=2e-4)


def test_trials_of_one_scene_widen_the_interval() -> None:
    alone = [trial(seed=k, good=k % 2 == 0) for k in range(100)]
    shared = [trial(seed=k // 10, good=(k // 10) % 2 == 0) for k in range(100)]
    narrow, wide = (rate("x", some, lambda t: t.good) for some in (alone, shared))
    assert wide.high - wide.low > 2 * (narrow.high - narrow.low)
    assert narrow.low < 0.5 < narrow.high and wide.share == narrow.share == 0.5


def test_a_scene_that_always_works_has_a_sure_rate() -> None:
    sure = rate("x", [trial(seed=k) for k in range(5)], lambda t: t.good)
    assert (sure.low, sure.high) == (1.0, 1.0) and sure.wilson[0] < 0.6


def test_causes_say_where_the_word_was_wrong() -> None:
    some = [
        trial(),
        trial(good=False, truthful=False),
        trial(good=False, status="slipped", executed=False),
        trial(status="moved", truthful=False, executed=False),
    ]
    causes = dict(summarise("grasp", some).causes)
    assert causes == {
        "removed": 1,
        "removed but not in the basket": 1,
        "slipped": 1,
        "moved but in the basket": 1,
    }


def test_classes_count_good_ones_and_all() -> None:
    push = {"tool": "push", "status": "pushed", "direction": "left", "distance": 0.1}
    some = [trial(**push, ratio=r, good=r > 0.5) for r in (0.2, 0.9, 1.0)]
    groups = dict(summarise("push", some).groups)
    assert groups["direction"] == (("left", 2, 3),) and groups["asked"] == (("8-14 cm", 2, 3),)
    assert dict(summarise("push", some).causes) == {"pushed": 2, "pushed, hardly moved": 1}


@pytest.mark.parametrize(
    ("value", "words"),
    [(0.01, "0-3 cm"), (0.03, "0-3 cm"), (0.031, "3-6 cm"), (0.1, "over 9 cm")],
)
def test_bands(value: float, words: str) -> None:
    assert band(value, 0.03, 0.06, 0.09) == words


def test_seconds_are_medians() -> None:
    some = [trial(planning=p) for p in (1.0, 2.0, 9.0)]
    times = {name: median for name, median, _ in summarise("grasp", some).seconds}
    assert times["planning"] == 2.0 and times["whole attempt"] == pytest.approx(2.3)
    assert np.isfinite(list(times.values())).all()
