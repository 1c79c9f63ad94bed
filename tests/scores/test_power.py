import math

import pytest
from statsmodels.stats.power import TTestPower

from probe.scores.power import PowerAssumptions, detectable_gap, expected_error

SUITE = {"find": 28, "compare": 24, "size": 28, "count": 21, "reduce": 23, "beneath": 26}


@pytest.mark.parametrize(("n", "power"), [(10, 0.8), (25, 0.8), (25, 0.9), (144, 0.8)])
def test_near_to_the_exact_power_of_a_t_test(n, power):
    # statsmodels solves the noncentral t distribution; the sum of two quantiles comes close.
    exact = TTestPower().solve_power(nobs=n, alpha=0.05, power=power, alternative="two-sided")
    found = detectable_gap(1 / math.sqrt(n), n - 1, power=power)
    assert found == pytest.approx(exact, rel=0.03)


def test_many_degrees_of_freedom_need_2_8_standard_errors():
    assert detectable_gap(0.01, 1e9) == pytest.approx(0.01 * (1.959964 + 0.841621), rel=1e-5)
    narrower = detectable_gap(0.01, 1e9, level=0.9)
    assert narrower == pytest.approx(0.01 * (1.644854 + 0.841621), rel=1e-5)


def test_the_error_of_equal_types_by_hand():
    # Variance of a task's difference: 2 * 0.25 * (0.6 * 0.5 + 0.4 / 2) = 0.25.
    outlook = PowerAssumptions(accuracy=0.5, icc=0.6, alike=0.5, runs=2)
    error, freedom = expected_error({"find": 25}, outlook)
    assert (error, freedom) == (pytest.approx(0.1), pytest.approx(24))
    error, freedom = expected_error({"find": 25, "size": 25}, outlook)
    assert (error, freedom) == (pytest.approx(0.1 / math.sqrt(2)), pytest.approx(48))


def test_what_makes_a_difference_harder_to_see():
    base = PowerAssumptions(accuracy=0.5, icc=0.5, alike=0.5, runs=3)
    harder = [
        PowerAssumptions(accuracy=0.5, icc=0.5, alike=0.0, runs=3),
        PowerAssumptions(accuracy=0.5, icc=0.5, alike=0.5, runs=1),
    ]
    easier = [
        PowerAssumptions(accuracy=0.9, icc=0.5, alike=0.5, runs=3),
        PowerAssumptions(accuracy=0.5, icc=0.5, alike=1.0, runs=3),
    ]
    middle = expected_error(SUITE, base)[0]
    assert all(expected_error(SUITE, it)[0] > middle for it in harder)
    assert all(expected_error(SUITE, it)[0] < middle for it in easier)


def test_luck_alone_is_binomial():
    # Runs unrelated to tasks: a difference of two means of 3 * 28 episodes.
    error, _ = expected_error(
        {"find": 28}, PowerAssumptions(accuracy=0.3, icc=0.0, alike=0.0, runs=3)
    )
    assert error == pytest.approx(math.sqrt(2 * 0.3 * 0.7 / (3 * 28)))
