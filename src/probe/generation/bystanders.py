"""Which candidates lie on the table beside the true one, so that being there tells nothing."""

from __future__ import annotations

import numpy as np

from probe.tasks.options import CANDIDATES


def draw_bystanders(count: int, rng: np.random.Generator) -> list[tuple[int, ...]]:
    """Of each candidate, by index, the ones that lie on the table with it, by index.

    Each candidate comes exactly once at each place among the bystanders, never beside itself.

    Args:
        count: Bystanders, fewer than candidates.
        rng: Draws the ring of candidates in which those that come next are the bystanders.
    """
    order: list[int] = rng.permutation(CANDIDATES).tolist()
    place = {index: at for at, index in enumerate(order)}
    return [
        tuple(order[(place[index] + step) % CANDIDATES] for step in range(1, count + 1))
        for index in range(CANDIDATES)
    ]
