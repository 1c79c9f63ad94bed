"""Lays both marked things beneath their covers, aimed by what is wrong with what shows."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np

from probe.generation.marked import (
    CoveredThing,
    MarkedStage,
    at_rest,
    draw_way_out,
    furthest_out,
    moved_out,
)
from probe.generation.result import Rejected
from probe.types import Array

Fit = Callable[[int, CoveredThing], int]
"""What is wrong with what shows of a thing, from its place (0 for A, 1 for B) and its nest: -1 if
it is too little, 1 if it is too much, 0 if it will do."""

_WAYS = 8
_WAYS_WITHOUT = 3
"""After so many ways without any pair that does, no more are tried: another cast is cheaper."""

_BISECTIONS = 7
_CHOICES = 3

_LEAST_RATIO, _RATIO = 1.15, 1.5
"""How many times as much is to show of the one as of the other, at least and best: the crowd takes
some, and what is at the edge of what will do may not stay there."""


def draw_aimed(
    made: MarkedStage,
    fit: Fit,
    facing: tuple[Array, Array],
    more_of_a: bool,
    rng: np.random.Generator,
) -> tuple[CoveredThing, CoveredThing]:
    """A and B, each partly beneath its cover; the distance to which each is moved is searched for.

    Args:
        made: The set.
        fit: Judges what shows of a thing.
        facing: Of A and of B, angles of the sides of which one is to look out, radians.
        more_of_a: Whether more pixels of A are to show than of B.
        rng: Draws how they lie.

    Raises:
        Rejected: Nothing that was tried does, or stays.
    """
    found: tuple[list[CoveredThing], list[CoveredThing]] = ([], [])
    for number in range(_WAYS):
        for place in (0, 1):
            side = float(rng.choice(facing[place]))
            found[place].extend(_fitting(made, place, fit, side, more_of_a == (place == 0), rng))
        pairs = [(a, b) for a, b in product(*found) if _ratio(a, b, more_of_a) >= _LEAST_RATIO]
        if not pairs and number + 1 >= _WAYS_WITHOUT:
            break
        pairs.sort(key=lambda pair: abs(_ratio(*pair, more_of_a) - _RATIO))
        for first, second in pairs[:_CHOICES]:
            a, b = at_rest(made, 0, first), at_rest(made, 1, second)
            if a and b and fit(0, a) == fit(1, b) == 0 and _ratio(a, b, more_of_a) > 1:
                return a, b
    raise Rejected("nest", "nothing that was tried shows as planned")


def _fitting(
    made: MarkedStage, place: int, fit: Fit, side: float, more: bool, rng: np.random.Generator
) -> list[CoveredThing]:
    """Nests that do, found by bisection along one way out; then on to where more or less shows."""
    way = draw_way_out(made, place, rng, side)
    low, high = 0.0, furthest_out(made, place)
    found: list[CoveredThing] = []
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        nest = moved_out(made, place, way, middle)
        jammed = made.stage.jammed
        wrong = fit(place, nest)
        if wrong == 0 and not jammed:
            found.append(nest)
        low, high = (middle, high) if wrong < 0 or (wrong == 0 and more) else (low, middle)
    return found


def _ratio(a: CoveredThing, b: CoveredThing, more_of_a: bool) -> float:
    """How many times as many pixels show of the thing of which more is to show."""
    more, less = (a, b) if more_of_a else (b, a)
    return more.seen.visible_px / less.seen.visible_px
