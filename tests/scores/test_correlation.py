"""Correlations over few models: by written-out formulas, and by closed forms if there are any."""

from __future__ import annotations

import math
from itertools import permutations

import numpy as np
import pytest

from probe.scores.correlation import (
    exact_interval,
    least_telling,
    order_p,
    pearson,
    share_below,
    spearman,
    spread_over,
)

X, Y = np.array([0.1, 0.5, 0.6, 0.9]), np.array([0.2, 0.7, 0.4, 0.8])


def written_out(x: np.ndarray, y: np.ndarray) -> float:
    n = len(x)
    top = n * sum(a * b for a, b in zip(x, y, strict=True)) - sum(x) * sum(y)
    spreads = [n * sum(a * a for a in row) - sum(row) ** 2 for row in (x, y)]
    return top / math.sqrt(spreads[0] * spreads[1])


def test_pearson_is_the_textbooks() -> None:
    assert float(pearson(X, Y)) == pytest.approx(written_out(X, Y), abs=1e-12)
    rows = pearson(np.array([X, X]), np.array([Y, -Y]))
    assert rows.tolist() == pytest.approx([written_out(X, Y), -written_out(X, Y)])


def test_spearman_without_ties_is_that_of_the_squared_rank_differences() -> None:
    # Ranks 1 2 3 4 and 1 3 2 4: 1 - 6 * 2 / (4 * 15).
    assert float(spearman(X, Y)) == pytest.approx(0.8)
    # Ties share their rank: 1 2.5 2.5 and 1 2 3.
    assert float(spearman(np.array([0, 1, 1]), np.array([0, 1, 2]))) == pytest.approx(
        written_out(np.array([1, 2.5, 2.5]), np.array([1, 2, 3]))
    )


def test_models_that_fare_alike_have_no_correlation() -> None:
    assert np.isnan(pearson(np.array([0.3, 0.3, 0.3]), np.array([0.1, 0.5, 0.9])))
    found, share = spread_over(np.array([0.5] * 96 + [np.nan] * 4))
    assert (found.low, found.high, share) == (-1.0, 1.0, 0.04)


def test_every_order_is_gone_through() -> None:
    rng = np.random.default_rng(0)
    found = written_out(X, Y)
    orders = [written_out(X, Y[list(order)]) for order in permutations(range(4))]
    as_good = sum(r >= found - 1e-9 for r in orders) / 24
    assert order_p(X, Y, rng, pearson) == as_good
    assert order_p(X, X, rng, spearman) == 1 / 24
    many = np.arange(12.0)
    assert order_p(many, many, rng, pearson) < 0.001


@pytest.mark.parametrize("r", [-0.9, 0.1, 0.5, 0.99])
def test_without_a_correlation_the_distribution_has_a_closed_form(r: float) -> None:
    assert share_below(r, 0.0, 3) == pytest.approx(1 - math.acos(r) / math.pi, abs=1e-5)
    assert share_below(r, 0.0, 4) == pytest.approx((1 + r) / 2, abs=1e-5)


@pytest.mark.parametrize(("rho", "n"), [(0.6, 3), (-0.3, 5), (0.8, 15)])
def test_samples_fall_as_the_distribution_says(rho: float, n: int) -> None:
    x, more = np.random.default_rng(1).standard_normal((2, 50_000, n))
    found = pearson(x, rho * x + math.sqrt(1 - rho**2) * more)
    for r in (-0.2, 0.5, 0.9):
        assert float((found < r).mean()) == pytest.approx(share_below(r, rho, n), abs=0.01)


def test_the_papers_three_models_leave_nearly_every_correlation_open() -> None:
    """Its r of 0.82: the ends are where samples of three fall beyond it in 2.5 % of cases."""
    found = exact_interval(0.82, 3)
    assert found is not None
    assert (found.low, found.high) == pytest.approx((-0.825, 0.991), abs=1e-3)
    assert share_below(0.82, found.low, 3) == pytest.approx(0.975, abs=1e-4)
    assert share_below(0.82, found.high, 3) == pytest.approx(0.025, abs=1e-4)
    assert exact_interval(1.0, 3) is None
    # Tables of critical values have 0.997 and 0.950 for one and two degrees of freedom.
    assert [round(least_telling(n), 3) for n in (3, 4)] == [0.997, 0.95]
