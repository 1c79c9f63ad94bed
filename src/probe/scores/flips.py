"""Permutation tests that swap, task by task, which of two results belongs to whom."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from probe.types import Array

FLIPS = 99_999
"""Draws of a test; so many that Holm's correction of 120 pairs leaves p below 0.01."""

_BATCH = 10_000
_ROUNDING = 1e-9


def flip_p(
    statistic: Callable[[Array], Array], tasks: int, rng: np.random.Generator, draws: int = FLIPS
) -> float:
    """Share of all ways to swap tasks that give at least the statistic that was found.

    All ways are tried if there are no more than `draws`; else so many are drawn, and what was
    found counts as one of them, so that p is never 0 (Phipson and Smyth, Stat. Appl. Genet. Mol.
    Biol. 9(1), 2010).

    Args:
        statistic: From swaps, 0 or 1, shape (m, tasks), to m numbers; larger is more extreme.
        tasks: How many can be swapped.
        rng: For the draws.
        draws: How many.
    """
    found = float(statistic(np.zeros((1, tasks)))[0])
    limit = found - _ROUNDING * max(1.0, abs(found))
    exact = 2**tasks <= draws
    batches = _all_swaps(tasks) if exact else _drawn(tasks, rng, draws)
    extreme = sum(int(np.count_nonzero(statistic(swaps) >= limit)) for swaps in batches)
    return extreme / 2**tasks if exact else (extreme + 1) / (draws + 1)


def sign_flip_p(weighted: Array, rng: np.random.Generator, draws: int = FLIPS) -> float:
    """Two-sided p of a weighted sum of differences that is 0 if neither side is better.

    Fisher's permutation test of pairs (The Design of Experiments, 1935, section 21).

    Args:
        weighted: Difference of each task times its weight, shape (n,).
        rng: For the draws.
        draws: How many.
    """
    differing = weighted[weighted != 0]
    return flip_p(lambda swaps: np.abs((1 - 2 * swaps) @ differing), len(differing), rng, draws)


def _all_swaps(tasks: int) -> Iterator[Array]:
    places = np.arange(tasks)
    for start in range(0, 2**tasks, _BATCH):
        numbers = np.arange(start, min(start + _BATCH, 2**tasks))
        yield ((numbers[:, None] >> places) & 1).astype(float)


def _drawn(tasks: int, rng: np.random.Generator, draws: int) -> Iterator[Array]:
    for start in range(0, draws, _BATCH):
        yield rng.integers(2, size=(min(_BATCH, draws - start), tasks), dtype=np.int8).astype(float)
