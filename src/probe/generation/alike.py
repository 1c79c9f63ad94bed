"""Draws objects that could stand for one another in a question."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.likeness import Likeness, longest, look, same_category
from probe.generation.result import Rejected
from probe.scene.turns import Leads, in_turn, nobody
from probe.types import Array

MOST_OF_A_KIND = 2
"""Things of one category in a set, if that can be: four balls that differ in colour say little."""

_TRIES, _VARIED_TRIES = 10, 30

_ENOUGH_LEADING = 3
"""Among things of which some lead, a set with so many of those is taken at once."""


def is_lying(spec: ObjectSpec) -> bool:
    """Whether a thing lies along its longest side."""
    return max(spec.size[:2]) == longest(spec)


def draw_alike(
    pool: Sequence[ObjectSpec],
    library: Sequence[ObjectSpec],
    likeness: Likeness,
    count: int,
    rng: np.random.Generator,
    *,
    varied: bool = False,
    leads: Leads = nobody,
) -> tuple[ObjectSpec, ...]:
    """Draw objects that could stand for one another.

    They come in random order, those that lead first; of several sets that with most of them is
    taken.

    Args:
        pool: Those that qualify.
        library: All objects, to count categories.
        likeness: How alike any two of them are.
        count: How many.
        rng: Draws them.
        varied: Whether a set with at most MOST_OF_A_KIND of one category is looked for first.
        leads: Which are to be drawn wherever they can.

    Raises:
        Rejected: Nothing qualifies, or what was drawn first has too few like it, several times.
    """
    if not pool:
        raise Rejected("candidates", "nothing here is of the right size")
    enough = min(_ENOUGH_LEADING, sum(map(leads, pool)))
    together, one_kind = likeness.pairs(pool, library), same_category(pool)
    place = {spec.id: number for number, spec in enumerate(pool)}

    drawn, best = list[ObjectSpec](), list[ObjectSpec]()
    limits = [MOST_OF_A_KIND] * _VARIED_TRIES if varied else []
    for most in [*limits, *[count] * _TRIES]:
        order = np.array([place[spec.id] for spec in in_turn(pool, leads, rng)])
        drawn = [pool[number] for number in _grown(order, count, most, together, one_kind)]
        if len(drawn) == count and (not best or sum(map(leads, drawn)) > sum(map(leads, best))):
            best = drawn
        if best and sum(map(leads, best)) >= enough:
            break
    if not best:
        found = f"only {len(drawn)} of {count} alike: {', '.join(spec.name for spec in drawn)}"
        raise Rejected("candidates", found)
    return tuple(best)


def _grown(order: Array, count: int, most: int, together: Array, one_kind: Array) -> list[int]:
    """The first that go together, so many at most, and at most so many of one category."""
    drawn = list[int]()
    while len(drawn) < count and len(order):
        drawn.append(first := int(order[0]))
        order = order[1:][together[first, order[1:]]]
        if one_kind[first, drawn].sum() == most:
            order = order[~one_kind[first, order]]
    return drawn


def unlike(specs: Sequence[ObjectSpec], taken: Sequence[ObjectSpec]) -> list[ObjectSpec]:
    """Those that can be told apart by name from every one of `taken`."""
    names, looks = {spec.name for spec in taken}, {look(spec) for spec in taken}
    return [spec for spec in specs if spec.name not in names and look(spec) not in looks]
