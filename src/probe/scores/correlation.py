"""Pearson's and Spearman's correlation over a few models, and how sure they are."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import permutations

import numpy as np
from scipy import integrate, optimize, special, stats

from probe.scores.intervals import LEVEL, Interval
from probe.types import Array

ALL_ORDERS = 8
"""Up to so many models, every order is gone through; beyond, ORDERS of them are drawn."""

ORDERS = 10_000
_NOTHING = 1e-12
"""A spread, or a distance from 1, that is due to rounding alone."""

_FAR, _STEPS = 18.0, 601
"""Of z: how far out nothing is left of any density, and in how many steps one is summed."""

Correlation = Callable[[Array, Array], Array]


def pearson(x: Array, y: Array) -> Array:
    """Pearson's r along the last axis, shape (..., n); nan where one of both doesn't vary."""
    across = x - x.mean(axis=-1, keepdims=True)
    along = y - y.mean(axis=-1, keepdims=True)
    spread = np.sqrt((across**2).sum(axis=-1) * (along**2).sum(axis=-1))
    fit = np.where(spread < _NOTHING, np.nan, spread)
    return np.clip((across * along).sum(axis=-1) / fit, -1, 1)


def spearman(x: Array, y: Array) -> Array:
    """Spearman's rho along the last axis: Pearson's r of the ranks; ties share their mean rank."""
    return pearson(stats.rankdata(x, axis=-1), stats.rankdata(y, axis=-1))


def spread_over(found: Array, level: float = LEVEL) -> tuple[Interval, float]:
    """Percentile interval of correlations that were drawn, shape (draws,).

    Draws without a correlation (nan: all models fared alike) may stand for any. They count as -1
    for the lower end and as 1 for the upper one, which can only widen the interval.

    Returns:
        The interval, and the share of such draws.
    """
    tail, none = (1 - level) / 2, np.isnan(found)
    low = float(np.quantile(np.where(none, -1.0, found), tail))
    high = float(np.quantile(np.where(none, 1.0, found), 1 - tail))
    return Interval(low, high), float(none.mean())


def order_p(x: Array, y: Array, rng: np.random.Generator, correlation: Correlation) -> float:
    """One-sided p: how often models in an order by chance correlate at least as well as found.

    For up to ALL_ORDERS models the test goes through all orders and is exact (Fisher, The Design of
    Experiments, 1935); for more it draws some (Phipson and Smyth, Stat. Appl. Genet. 9(1), 2010).

    Args:
        x: A number of each model, shape (n,), not all alike.
        y: Another one, likewise.
        rng: For the draws.
        correlation: Which.
    """
    n, every = len(x), len(x) <= ALL_ORDERS
    orders = np.array(
        list(permutations(range(n))) if every else [rng.permutation(n) for _ in range(ORDERS)]
    )
    as_good = int((correlation(x, y[orders]) >= float(correlation(x, y)) - _NOTHING).sum())
    return as_good / len(orders) if every else (as_good + 1) / (len(orders) + 1)


def least_telling(n: int, level: float = LEVEL) -> float:
    """The r that n models, 3 or more, have to exceed for a two-sided t test to exclude 0."""
    t = float(stats.t.isf((1 - level) / 2, n - 2))
    return t / math.sqrt(n - 2 + t**2)


def exact_interval(r: float, n: int, level: float = LEVEL) -> Interval | None:
    """The interval of r for n models that are a sample of a bivariate normal distribution.

    Its ends are where the exact distribution of r has its tails beyond the r that was found.
    Fisher's z needs four models and is rough with so few.

    Args:
        r: As it was found.
        n: How many models, 3 or more.
        level: Share of samples whose interval should hold the true one.

    Returns:
        None for a perfect r, of which that distribution says nothing.
    """
    if 1 - abs(r) < _NOTHING:
        return None

    def end(share: float) -> float:
        def excess(z: float) -> float:
            return share_below(r, math.tanh(z), n) - share

        return math.tanh(float(optimize.brentq(excess, -_FAR, _FAR, xtol=1e-7)))

    tail = (1 - level) / 2
    return Interval(end(1 - tail), end(tail))


def share_below(r: float, rho: float, n: int) -> float:
    """Chance that n pairs of a normal distribution with this rho have a correlation below r.

    The density is Hotelling's (J. R. Stat. Soc. B 15(2), 1953), summed over z, whose hyperbolic
    tangent is the correlation; over the correlation itself it has poles.
    """
    middle, last = math.atanh(rho), math.atanh(r)
    z = np.linspace(min(middle, last) - _FAR, last, _STEPS)
    series = special.hyp2f1(0.5, 0.5, n - 0.5, (1 + rho * np.tanh(z)) / 2)
    logs = (_log_cosh(z) - _log_cosh(middle)) / 2 - (n - 1.5) * _log_cosh(z - middle)
    logs += math.lgamma(n - 1) - math.lgamma(n - 0.5) + math.log((n - 2) / math.sqrt(math.tau))
    return min(1.0, float(integrate.simpson(series * np.exp(logs), z)))


def _log_cosh(z: Array | float) -> Array:
    return np.logaddexp(z, np.negative(z)) - math.log(2)
