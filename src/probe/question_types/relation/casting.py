"""Who plays in Relation: five candidates, the thing that is named, and a cover three times."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import SIDES_TOLERANCE, TWIN_TOLERANCE, draw_alike
from probe.generation.covers import Cover, draw_cover, footprint_of
from probe.generation.object_selection import LARGEST, ObjectSelection, hideable, needs_alike
from probe.generation.side_by_side import Hidden, liftable, select
from probe.generation.task_plan import TaskPlan
from probe.generation.toppings import is_topped, some_of, with_toppings
from probe.question_types.relation.truth import RING
from probe.tasks.english import plural
from probe.tasks.options import CANDIDATES

NEEDS = needs_alike(LARGEST, TWIN_TOLERANCE, CANDIDATES + 1, sides=True)
"""What lies beneath the covers, for people."""

_FEWEST, _MOST = 5, 8
"""Things around the covers."""


def select_relation(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Alike things to be beneath covers, one of them to be named, a cover three times, a crowd.

    Raises:
        Rejected: The library has no such set.
    """

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        countable = [spec for spec in liftable(free) if plural(spec.name)]
        cover = draw_cover(library, countable, hidden.room, rng)
        return [cover] * RING if cover else []

    cast = select(library, draw, int(rng.integers(_FEWEST, _MOST + 1)), rng, _hidden)
    return with_toppings(library, cast, some_of(RING, rng), rng) if is_topped(plan) else cast


def draw_bystanders(rng: np.random.Generator) -> tuple[int, ...]:
    """Of each candidate, the one that lies on the table with it, by index.

    Each candidate is the bystander of exactly one other.
    """
    order: list[int] = rng.permutation(CANDIDATES).tolist()
    after = dict(zip(order, [*order[1:], order[0]], strict=True))
    return tuple(after[index] for index in range(CANDIDATES))


def _hidden(library: Library, rng: np.random.Generator) -> Hidden:
    """Draw things that are alike in length, width and height.

    Raises:
        Rejected: The library has too few.
    """
    specs = draw_alike(
        hideable(library),
        library.specs,
        TWIN_TOLERANCE,
        CANDIDATES + 1,
        rng,
        sides=SIDES_TOLERANCE,
        leads=library.leads,
    )
    room = tuple(footprint_of(library, spec.id) for spec in specs)
    return Hidden(specs[:CANDIDATES], specs[CANDIDATES:], room)
