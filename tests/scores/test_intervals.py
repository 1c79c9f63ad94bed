import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from statsmodels.stats.proportion import proportion_confint

from probe.scores.estimates import macro
from probe.scores.intervals import (
    DIFFERENCES,
    Interval,
    SeveralRuns,
    bootstrap,
    standard_error,
    student,
    wilson,
)
from score_rows import unit, units

SHARES = st.sampled_from([0, 1 / 3, 2 / 3, 1])
STRATA = st.dictionaries(
    st.sampled_from(["count", "find", "size"]),
    st.lists(SHARES, min_size=1, max_size=12).map(np.array),
    min_size=1,
)


@pytest.mark.parametrize(("right", "n"), [(0, 5), (5, 5), (1, 1), (0, 1), (13, 28), (27, 28)])
@pytest.mark.parametrize("level", [0.95, 0.9])
def test_wilson_as_statsmodels_has_it(right, n, level):
    found = wilson(units("find", *[1.0] * right, *[0.0] * (n - right)), level)
    expected = proportion_confint(right, n, alpha=1 - level, method="wilson")
    assert (found.low, found.high) == pytest.approx(expected, abs=1e-12)


def test_wilson_refuses_tasks_that_were_run_twice():
    with pytest.raises(
        SeveralRuns,
        match=r"find-2 was run 2 times.* Use the bootstrap or the stratified t interval\.$",
    ):
        wilson([unit("find-1", 1), unit("find-2", 1, 0)])


def test_one_type_has_the_ordinary_standard_error():
    values = np.array([1, 0, 1 / 3, 1, 2 / 3])
    error, freedom = standard_error({"find": values})
    assert error == pytest.approx(stats.sem(values))
    assert freedom == pytest.approx(4)


def test_one_type_has_the_ordinary_t_interval():
    values = np.array([1, 0, 1 / 3, 1, 2 / 3, 0, 0, 1])
    low, high = stats.t.interval(0.95, 7, values.mean(), stats.sem(values))
    found = student({"find": values})
    assert (found.low, found.high) == pytest.approx((low, high))
    low, high = stats.t.interval(0.8, 7, values.mean(), stats.sem(values))
    found = student({"find": values}, level=0.8)
    assert (found.low, found.high) == pytest.approx((low, high))


def test_two_types_are_welchs_test_of_two_samples():
    # The mean of x and y varies like half of x - (-y), whose interval scipy gives by Welch's t.
    x, y = np.array([1, 0, 1 / 3, 1, 2 / 3]), np.array([0, 0, 1, 1 / 3, 0, 0, 1 / 3])
    welch = stats.ttest_ind(x, -y, equal_var=False)
    error, freedom = standard_error({"find": x, "size": y})
    assert freedom == pytest.approx(welch.df)
    expected = welch.confidence_interval(0.95)
    found = student({"find": x, "size": y})
    assert (2 * found.low, 2 * found.high) == pytest.approx((expected.low, expected.high))
    assert 2 * error == pytest.approx(math.hypot(stats.sem(x), stats.sem(y)))


def test_bootstrap_agrees_with_scipy_once_widened():
    rng = np.random.default_rng(5)
    x, y = rng.binomial(3, 0.6, 28) / 3, rng.binomial(3, 0.3, 9) / 3
    found = bootstrap({"find": x, "size": y}, seed=1, draws=40_000)

    # scipy's own draws of values that were spread by sqrt(n / (n - 1)) about their mean.
    wide = [v.mean() + math.sqrt(len(v) / (len(v) - 1)) * (v - v.mean()) for v in (x, y)]
    expected = stats.bootstrap(
        wide,
        lambda a, b, axis: (a.mean(axis=axis) + b.mean(axis=axis)) / 2,
        n_resamples=40_000,
        method="percentile",
        rng=np.random.default_rng(6),
    ).confidence_interval
    assert (found.low, found.high) == pytest.approx((expected.low, expected.high), abs=0.006)
    assert found.high - found.low > 0.05


def test_the_bootstrap_spreads_as_the_standard_error_says():
    values = {"find": np.array([1.0, 0, 0, 1 / 3, 1, 2 / 3]), "size": np.array([0, 1.0, 1 / 3, 0])}
    # Of a normal distribution, 68.27 % lie within one standard error.
    found = bootstrap(values, seed=3, draws=100_000, level=0.6827)
    error, _ = standard_error(values)
    assert (found.high - found.low) / 2 == pytest.approx(error, rel=0.05)


def test_two_tasks_are_widened_most():
    # Half of the draws take both tasks, a quarter each one twice: 0, 0.5 or 1, times sqrt(2).
    found = bootstrap({"find": np.array([0.4, 0.6])}, seed=0)
    assert (found.low, found.high) == pytest.approx((0.5 - 0.1 * 2**0.5, 0.5 + 0.1 * 2**0.5))


def test_types_are_drawn_apart():
    # If both types drew alike, the mirror image of a type would cancel it out.
    values = np.array([1.0, 0, 0, 1, 1 / 3, 1])
    found = bootstrap({"find": values, "size": 1 - values}, seed=0)
    assert found.high - found.low > 0.3


def test_the_same_seed_gives_the_same_interval_and_another_another():
    values = {"find": np.linspace(0, 1, 17)}
    assert bootstrap(values, seed=1) == bootstrap(values, seed=1)
    assert bootstrap(values, seed=1) != bootstrap(values, seed=2)


@pytest.mark.parametrize("make", [student, lambda strata, **more: bootstrap(strata, 0, **more)])
class TestTasksThatAreAllAlike:
    @pytest.mark.parametrize("n", [1, 2, 28])
    def test_all_right_or_all_wrong_is_wilsons(self, make, n):
        low, high = proportion_confint(n, n, method="wilson")
        found = make({"find": np.ones(n)})
        assert (found.low, found.high) == pytest.approx((low, high))
        found = make({"find": np.zeros(n)})
        assert (found.low, found.high) == pytest.approx((1 - high, 1 - low))

    def test_a_third_everywhere_leaves_room_on_both_sides(self, make):
        # Up to z^2 / (4 + z^2) of tasks may be all wrong, or all right.
        unseen = 1.959964**2 / (4 + 1.959964**2)
        found = make({"find": np.full(4, 1 / 3)})
        assert found.low == pytest.approx(1 / 3 - unseen / 3)
        assert found.high == pytest.approx(1 / 3 + unseen * 2 / 3)

    def test_no_difference_anywhere_may_still_be_one(self, make):
        unseen = 1.959964**2 / (4 + 1.959964**2)
        found = make({"find": np.zeros(4)}, limits=DIFFERENCES)
        assert (found.low, found.high) == pytest.approx((-unseen, unseen))

    def test_the_same_difference_everywhere_leaves_unequal_room(self, make):
        unseen = 1.959964**2 / (9 + 1.959964**2)
        found = make({"find": np.full(9, 1 / 3)}, limits=DIFFERENCES)
        assert found.low == pytest.approx(1 / 3 - unseen * 4 / 3)
        assert found.high == pytest.approx(1 / 3 + unseen * 2 / 3)

    def test_they_add_to_what_varies_by_squares(self, make):
        varies = np.array([1.0, 0, 1 / 3, 1, 0, 0, 1 / 3, 2 / 3])
        alone = make({"find": varies})
        both = make({"find": varies, "size": np.ones(3)})
        centre = (varies.mean() + 1) / 2
        unseen = 1.959964**2 / (3 + 1.959964**2)
        below = math.hypot((varies.mean() - alone.low) / 2, unseen / 2)
        assert centre - both.low == pytest.approx(below, abs=1e-3)
        assert both.high - centre == pytest.approx((alone.high - varies.mean()) / 2, abs=1e-3)


def test_a_single_task_of_a_type_has_no_variance_of_its_own():
    many = np.array([1.0, 0, 1, 1 / 3])
    error, freedom = standard_error({"find": many, "size": np.array([1.0])})
    assert error == pytest.approx(stats.sem(many) / 2)
    assert freedom == pytest.approx(3)
    assert standard_error({"size": np.array([1.0])}) == (0.0, 0.0)
    assert standard_error({"size": np.ones(9)}) == (0.0, 0.0)


@given(STRATA, st.integers(0, 5))
def test_intervals_hold_the_estimate_and_stay_within_limits(strata, seed):
    for found in (student(strata), bootstrap(strata, seed, draws=200)):
        assert 0 <= found.low <= macro(strata) + 1e-12
        assert macro(strata) - 1e-12 <= found.high <= 1
        assert found.low < found.high


@given(STRATA)
def test_right_and_wrong_are_mirror_images(strata):
    here, there = (
        student(strata),
        student({question_type: 1 - v for question_type, v in strata.items()}),
    )
    assert (here.low, here.high) == pytest.approx((1 - there.high, 1 - there.low))


@given(STRATA)
def test_a_wider_level_is_wider(strata):
    narrow, wide = student(strata, level=0.8), student(strata, level=0.99)
    assert wide.low <= narrow.low + 1e-12
    assert narrow.high <= wide.high + 1e-12


def test_an_interval_is_two_numbers():
    assert Interval(0.1, 0.2).low == 0.1
