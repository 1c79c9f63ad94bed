# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

import numpy as np
import pytest

from probe.scores.breakdown import Outcomes, Spread, effort, execution, outcomes, spread
from score_rows import faulty, row

STILL = {"manipulations": 0, "manipulated": False}


def test_outcomes_by_type():
    rows = [
        row("size-1"),
        row("size-1", run=1),
        row("size-1", run=2),
        row("size-1", run=3),
        row("size-2", **STILL),
        row("size-3", False),
        row("size-4", False),
        row("size-5", False, **STILL),
        row("size-6", False, **STILL),
        row("size-7", False, **STILL),
        faulty("size-8"),
        row("find-1", False),
    ]
    assert outcomes(rows) == [Outcomes("find", 0, 1, 0, 0, 0), Outcomes("size", 4, 2, 1, 3, 1)]
    assert outcomes([]) == []


def test_a_spread_by_hand():
    # 0 .. 10: the tenth percentile of eleven is the second.
    found = spread([*range(11), None])
    assert found == Spread(n=11, mean=5.0, median=5.0, p10=1.0, p90=9.0, total=55.0)
    assert spread([1, 2]) == Spread(2, 1.5, 1.5, pytest.approx(1.1), pytest.approx(1.9), 3)
    assert spread([4]) == Spread(1, 4, 4, 4, 4, 4)
    assert spread([None, None]) is None
    assert spread([]) is None


def test_effort_leaves_out_what_failed_and_what_is_unknown():
    rows = [
        row("find-1", turns=3, manipulations=2, perceptions=1, cost=0.5, tokens_in=100),
        row("find-2", turns=40, manipulations=10, perceptions=9, cost=1.5, turns_spent=True,
            manipulations_spent=True, end="out_of_turns", seconds_agent=2.0),
        row("find-3", turns=8, manipulations=10, perceptions=5, manipulations_spent=True),
        faulty("find-4", turns=1000, cost=99.0, turns_spent=True, manipulations_spent=True),
    ]  # fmt: skip
    found = effort(rows)
    assert found.episodes == 3
    assert (found.turns.n, found.turns.mean, found.turns.median) == (3, 17, 8)
    assert (found.manipulations.total, found.perceptions.total) == (22, 15)
    assert (found.turns_spent, found.manipulations_spent) == (1, 2)
    assert (found.cost.n, found.cost.total) == (2, 2.0)
    assert (found.tokens_in.total, found.tokens_out, found.seconds_tools) == (100, None, None)
    assert found.seconds_agent.mean == 2
    some = row("find-5", seconds_tools=3.0, tokens_out=7)
    assert (effort([some]).seconds_tools.total, effort([some]).tokens_out.total) == (3, 7)


def test_effort_of_nobody():
    found = effort([])
    assert (found.episodes, found.turns, found.cost) == (0, None, None)


def reduce(task: str, right: bool, exact: bool, **changes):
    values = {
        "precision": 1.0,
        "recall": 1.0,
        "exact": exact,
        "attempts_a_removal": 1.0,
        "others_disturbed": 0,
        "strict": right and exact,
    }
    return row(task, right, **(values | changes))


def test_execution_is_a_mean_over_what_says_something():
    rows = [
        reduce("reduce-1", True, True),
        reduce("reduce-2", False, False, precision=0.5, recall=0.25, attempts_a_removal=2.5,
               others_disturbed=3),
        reduce("reduce-3", True, False, precision=None, recall=0.0, attempts_a_removal=None),
        reduce("reduce-4", False, True),
        faulty("reduce-5", exact=False, others_disturbed=9, strict=False),
        row("find-1"),
    ]  # fmt: skip
    found = execution(rows)
    assert found.episodes == 4
    assert found.precision == pytest.approx(2.5 / 3)
    assert found.recall == pytest.approx(2.25 / 4)
    assert (found.exact, found.strict) == (0.5, 0.25)
    assert found.attempts_a_removal == pytest.approx(1.5)
    assert found.others_disturbed == pytest.approx(np.mean([0, 3, 0, 0]))


def test_no_reduce_no_execution():
    assert execution([row("find-1"), faulty("reduce-1", exact=False)]) is None
    nothing = execution([reduce("reduce-1", False, False, precision=None, attempts_a_removal=None)])
    assert (nothing.precision, nothing.attempts_a_removal) == (None, None)
