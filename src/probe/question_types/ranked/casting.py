"""Who plays in Ranked: things of several lengths, three like covers over them, and a crowd."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import Cover, draw_cover
from probe.generation.object_selection import ObjectSelection
from probe.generation.side_by_side import COVERS, Hidden, liftable, select
from probe.generation.task_plan import TaskPlan
from probe.generation.toppings import is_topped, some_of, with_toppings
from probe.question_types.ranked.ladder import companions, draw_ladder
from probe.tasks.english import plural
from probe.tasks.type_rules import Form

_FEWEST, _MOST = 5, 8
"""Things around the covers."""


def select_ranked(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """A cover three times, things of several lengths to be beneath them, and a crowd.

    Raises:
        Rejected: The library has no such set.
    """

    def hide(library: Library, rng: np.random.Generator) -> Hidden:
        return draw_ladder(library, plan.form, rng)

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        deep = [spec for spec in liftable(free) if spec.hollow and plural(spec.name)]
        cover = draw_cover(library, deep, hidden.room, rng)
        # A cover that rests on what it hides stands as high as that allows.
        stands = cover is not None and cover.depth >= max(it.height for it in hidden.room)
        return [cover] * COVERS if cover is not None and stands else []

    cast = select(library, draw, int(rng.integers(_FEWEST, _MOST + 1)), rng, hide)
    return with_toppings(library, cast, some_of(COVERS, rng), rng) if is_topped(plan) else cast


def draw_companions(
    cast: ObjectSelection, form: Form, rng: np.random.Generator
) -> Sequence[tuple[int, int]]:
    """Of each candidate, two things beside which it has the rank, by instance on a stage."""
    specs = (*cast.candidates, *cast.beneath)
    drawn: list[tuple[int, int]] = []
    for index in range(len(cast.candidates)):
        pairs = companions(form, specs, index)
        one, other = pairs[int(rng.integers(len(pairs)))]
        drawn.append((one + 1, other + 1))
    return drawn
