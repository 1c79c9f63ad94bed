"""Who plays in Relation: five candidates, the thing that is named, and a cover three times."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import Cover, draw_cover
from probe.generation.likeness import TWIN_TOLERANCE
from probe.generation.object_selection import LARGEST, ObjectSelection, needs_alike
from probe.generation.side_by_side import Hidden, liftable, select
from probe.generation.task_plan import TaskPlan
from probe.generation.toppings import is_topped, some_of, with_toppings
from probe.question_types.relation.truth import RING
from probe.tasks.english import plural
from probe.tasks.options import CANDIDATES

NAMED = 1
"""Things beneath covers that the question names."""

NEEDS = needs_alike(LARGEST, TWIN_TOLERANCE, CANDIDATES + NAMED, sides=True)
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

    hide = partial(Hidden.drawn, rules=plan.rules, secrets=NAMED)
    cast = select(library, draw, int(rng.integers(_FEWEST, _MOST + 1)), rng, hide)
    return with_toppings(library, cast, some_of(RING, rng), rng) if is_topped(plan) else cast
