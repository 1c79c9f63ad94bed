# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.scores.icc import icc
from probe.scores.units import Unit
from score_rows import unit

SHROUT_FLEISS = [
    [9, 2, 5, 8],
    [6, 1, 3, 2],
    [8, 4, 6, 8],
    [7, 1, 2, 6],
    [10, 5, 6, 9],
    [6, 2, 4, 7],
]
"""Six targets, four ratings each: table 2 of Psychol. Bull. 86(2), 1979; ICC(1, 1) is .17."""


def published(question_type: str = "find"):
    return [
        Unit(f"{question_type}-{i}", question_type, tuple(map(float, runs)))
        for i, runs in enumerate(SHROUT_FLEISS)
    ]


def test_the_published_example():
    found = icc(published())
    assert found == pytest.approx(0.17, abs=0.005)
    # Mean squares of their table 3: 11.24 between targets, 6.26 within.
    assert found == pytest.approx((11.2417 - 6.2639) / (11.2417 + 3 * 6.2639), abs=1e-4)


def test_types_are_pooled_by_their_mean_squares_and_their_means_play_no_part():
    shifted = [
        Unit(u.task, u.question_type, tuple(r + 100 for r in u.runs)) for u in published("size")
    ]
    assert icc([*published(), *shifted]) == pytest.approx(icc(published()))


def test_runs_that_always_agree():
    assert icc([unit("find-1", 1, 1, 1), unit("find-2", 0, 0, 0)]) == pytest.approx(1)


def test_by_hand_below_zero():
    # Between 0, within 2 * 0.5 / 2 = 0.5: (0 - 0.5) / (0 + 0.5).
    assert icc([unit("find-1", 1, 0), unit("find-2", 0, 1)]) == pytest.approx(-1)


def test_unequal_runs_by_hand():
    # Runs (1, 1, 0), (0,): mean 0.5; between = 3 (2/3 - 1/2)^2 + (0 - 1/2)^2 = 1/3 on 1 degree;
    # within = 2/3 on 2 degrees; runs a task = 4 - (9 + 1) / 4 = 1.5 on 1 degree.
    found = icc([unit("find-1", 1, 1, 0), unit("find-2", 0)])
    assert found == pytest.approx((1 / 3 - 1 / 3) / (1 / 3 + 0.5 / 3), abs=1e-12)
    # Runs (1, 1, 1), (0,): within 0 gives 1 whatever the rest.
    assert icc([unit("find-1", 1, 1, 1), unit("find-2", 0)]) == pytest.approx(1)
    # Runs (1, 1), (0, 1, 0, 0), (0,): N = 7, mean 3/7; between = 2 (4/7)^2 + 4 (1/4 - 3/7)^2
    # + (3/7)^2 = 54/56 on 2; within = 3/4 on 4; runs = (7 - (4 + 16 + 1) / 7) / 2 = 2.
    between, within = 54 / 56 / 2, 3 / 16
    found = icc([unit("find-1", 1, 1), unit("find-2", 0, 1, 0, 0), unit("find-3", 0)])
    assert found == pytest.approx((between - within) / (between + within))


@pytest.mark.parametrize(
    "units",
    [
        [],
        [unit("find-1", 1, 0)],  # one task
        [unit("find-1", 1, 0), unit("size-1", 0, 0)],  # one task a type
        [unit("find-1", 1), unit("find-2", 0)],  # one run
        [unit("find-1", 1, 1), unit("find-2", 1, 1)],  # nothing varies
    ],
)
def test_nothing_to_tell_it_from(units):
    assert icc(units) is None


def test_a_type_of_one_task_says_something_of_the_luck_of_runs():
    # Within: (2 * 0.25 + 0 + 0) / 3; between 1 on 1 degree from the other type, 2 runs a task.
    found = icc([unit("size-1", 1, 0), unit("find-1", 1, 1), unit("find-2", 0, 0)])
    within = 0.5 / 3
    assert found == pytest.approx((1 - within) / (1 + within))


@given(
    st.lists(st.lists(st.sampled_from([0.0, 1.0]), min_size=3, max_size=3), min_size=2, max_size=9)
)
def test_equal_runs_as_the_analysis_of_variance_gives_it(runs):
    found = icc([Unit(f"find-{i}", "find", tuple(it)) for i, it in enumerate(runs)])
    table = np.array(runs)
    between = 3 * table.mean(axis=1).var(ddof=1)
    within = table.var(axis=1, ddof=1).mean()
    if between + within == 0:
        assert found is None
    else:
        assert found == pytest.approx((between - within) / (between + 2 * within))
