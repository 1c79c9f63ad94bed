"""Lays both marked things beneath their covers so that what shows of the two goes together."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product
from typing import TypeVar

import numpy as np

from probe.generation.marked import CoveredThing, MarkedStage, at_rest, peeks
from probe.generation.result import Rejected
from probe.generation.visibility_rules import LITTLE
from probe.types import Array

_ROUNDS = 5
_CHOICES = 2

MOST = 0.28
"""Largest share to begin with: what shows by more than SEEN_SHARE once all is laid is named."""

_T = TypeVar("_T")


def draw_nests(
    made: MarkedStage,
    shown: Callable[[int, CoveredThing], _T | None],
    off: Callable[[_T, _T], float],
    rng: np.random.Generator,
    facing: tuple[Array, Array] | None = None,
) -> tuple[CoveredThing, CoveredThing]:
    """A and B, each partly beneath its cover; many ways of lying are tried.

    Args:
        made: The set.
        shown: What shows of a thing, from its place (0 for A, 1 for B) and its nest; None if that
            is of no use.
        off: How far what shows of A and of B is from what is wanted; infinity if it won't do.
        rng: Draws how they lie.
        facing: Of A and of B, angles of the sides of which one is to look out; None for any.

    Raises:
        Rejected: Nothing that was tried does, or stays.
    """
    found: tuple[list[tuple[CoveredThing, _T]], list[tuple[CoveredThing, _T]]] = ([], [])
    for _ in range(_ROUNDS):
        for place in (0, 1):
            wanted = math.exp(rng.uniform(math.log(LITTLE[0]), math.log(MOST)))
            side = float(rng.choice(facing[place])) if facing else None
            nests = [n for n in peeks(made, place, wanted, rng, side) if n.seen.fraction <= MOST]
            found[place].extend((n, it) for n in nests if (it := shown(place, n)) is not None)
        pairs = [(off(a, b), first, second) for (first, a), (second, b) in product(*found)]
        doing = sorted((pair for pair in pairs if pair[0] < math.inf), key=lambda pair: pair[0])
        for _, first, second in doing[:_CHOICES]:
            a, b = at_rest(made, 0, first), at_rest(made, 1, second)
            if a and b and _does(shown(0, a), shown(1, b), off):
                return a, b
    raise Rejected("nest", "nothing that was tried shows as planned")


def _does(a: _T | None, b: _T | None, off: Callable[[_T, _T], float]) -> bool:
    return a is not None and b is not None and off(a, b) < math.inf
