import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from probe.scores.flips import flip_p, sign_flip_p

RNG = np.random.default_rng


def by_enumeration(values) -> float:
    """Share of all signs whose sum is at least as far from 0."""
    found = abs(sum(values))
    ways = [
        abs(sum(s * v for s, v in zip(signs, values, strict=True)))
        for signs in itertools.product((1, -1), repeat=len(values))
    ]
    return sum(way >= found - 1e-12 for way in ways) / len(ways)


@given(st.lists(st.sampled_from([-1, -2 / 3, -1 / 3, 0, 1 / 3, 2 / 3, 1]), max_size=9))
def test_all_signs_are_tried_where_they_are_few(values):
    assert sign_flip_p(np.array(values), RNG(0)) == pytest.approx(by_enumeration(values))


@pytest.mark.parametrize(
    ("values", "p"),
    [
        ([1, 1, 1], 2 / 8),
        ([1, 1, 1, 1, 1], 2 / 32),
        ([1, 1, -1], 1.0),  # of 8 sums, 2 are 3 off and 6 are 1 off
        ([0, 0, 0], 1.0),
        ([], 1.0),
        ([0.5], 1.0),
        ([2, 1], 2 / 4),
    ],
)
def test_cases_by_hand(values, p):
    assert sign_flip_p(np.array(values, dtype=float), RNG(0)) == pytest.approx(p)


def test_as_scipy_has_it_for_one_sample():
    values = RNG(3).normal(0.4, 1, 11)
    expected = stats.permutation_test(
        (values,), sum, permutation_type="samples", vectorized=False, n_resamples=10**9
    ).pvalue
    assert sign_flip_p(values, RNG(0)) == pytest.approx(expected)


def test_draws_come_near_to_full_enumeration():
    values = RNG(4).choice([-1 / 3, 1 / 3, 2 / 3], 16)
    exact = by_enumeration(values)
    drawn = sign_flip_p(values, RNG(1), draws=20_000)
    assert drawn == pytest.approx(exact, abs=4 * np.sqrt(exact * (1 - exact) / 20_000))
    assert drawn != sign_flip_p(values, RNG(7), draws=20_000)


def test_a_drawn_p_is_never_zero():
    assert sign_flip_p(np.ones(80), RNG(0), draws=999) == 1 / 1000


def test_exactly_as_many_ways_as_draws_are_still_all_tried():
    values = np.array([1.0, 1, 1])
    assert sign_flip_p(values, RNG(0), draws=8) == 2 / 8
    assert round(9 * sign_flip_p(values, RNG(0), draws=7)) != 2 * 9 / 8
    assert (sign_flip_p(values, RNG(0), draws=7) * 8).is_integer()


def test_batches_leave_nothing_out_and_take_nothing_twice():
    seen = []

    def statistic(swaps):
        seen.append(swaps.copy())
        return np.zeros(len(swaps))

    assert flip_p(statistic, 15, RNG(0)) == 1
    first, tried = seen[0], np.concatenate(seen[1:])
    assert not first.any()
    assert tried.shape == (2**15, 15)
    assert len(np.unique(tried, axis=0)) == 2**15

    seen.clear()
    assert flip_p(statistic, 40, RNG(0), draws=25_001) == 1
    drawn = np.concatenate(seen[1:])
    assert drawn.shape == (25_001, 40)
    assert set(np.unique(drawn)) == {0, 1}
    assert drawn.mean() == pytest.approx(0.5, abs=0.002)


def test_equal_ways_count_however_they_are_rounded():
    # 0.1 + 0.2 differs from 0.3 in its last bit: both signs of the first three give the same sum.
    values = np.array([0.1, 0.2, -0.3, 1.0])
    assert sign_flip_p(values, RNG(0)) == pytest.approx(by_enumeration(values))
    # Of (0.1 + 0.2, -0.3) all ways are at least as far as 5.6e-17 from 0.
    assert sign_flip_p(np.array([0.1, 0.2, -0.3]), RNG(0)) == 1


def test_a_large_statistic_is_compared_by_its_size():
    def statistic(swaps):
        return 1e12 - swaps.sum(axis=1)

    assert flip_p(statistic, 3, RNG(0)) == 1
