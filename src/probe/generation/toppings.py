"""Things that lie on covers, so that something else has to go first."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import unlike
from probe.generation.covers import Cover, can_top
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import Rejected
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.scene.turns import in_turn
from probe.tasks.task import PILE_RULES

TOPPED = PlannedProperty("topped", (False, True))
"""Whether something lies on a cover that the question is about."""

_CLOSER = 0.75


def is_topped(plan: TaskPlan) -> bool:
    """Whether a plan asks for that; rules before PILE_RULES never do."""
    return plan.rules >= PILE_RULES and TOPPED.of(plan)


def keep_off(plan: TaskPlan, wider: float) -> float:
    """How much wider than a cover the disc is that the crowd is kept off: in a pile it leans on it.

    Args:
        plan: Of a type that is planned by TOPPED.
        wider: The same where nothing lies on a cover.
    """
    return wider * _CLOSER if is_topped(plan) else wider


def some_of(covers: int, rng: np.random.Generator) -> list[int]:
    """One or more of so many covers, by number from 0."""
    count = int(rng.integers(1, covers + 1))
    return [int(number) for number in rng.permutation(covers)[:count]]


def with_toppings(
    library: Library, cast: ObjectSelection, over: Sequence[int], rng: np.random.Generator
) -> ObjectSelection:
    """The cast with a thing to lie on each of some covers, and as many of the crowd less.

    Args:
        library: To choose from.
        cast: Who plays; nothing lies on its covers.
        over: Which of its covers, by number from 0.
        rng: Draws the things.

    Raises:
        Rejected: The library has nothing that stays on one of them.
    """
    drawn = draw_toppings(library, cast.specs, [cast.covers[number] for number in over], rng)
    crowd = cast.others[: len(cast.others) - len(drawn)]
    return replace(cast, others=(*crowd, *drawn), topped=tuple(over))


def draw_toppings(
    library: Library,
    taken: Sequence[ObjectSpec],
    covers: Sequence[Cover],
    rng: np.random.Generator,
) -> tuple[ObjectSpec, ...]:
    """Draw a thing to lie on each of some covers.

    Args:
        library: To choose from.
        taken: What is on the table.
        covers: What they lie on.
        rng: Draws them.

    Raises:
        Rejected: The library has nothing that stays on one of them.
    """
    drawn: list[ObjectSpec] = []
    for cover in covers:
        free = in_turn(unlike(library.specs, [*taken, *drawn]), library.leads, rng)
        fitting = next((spec for spec in free if can_top(spec, cover)), None)
        if fitting is None:
            raise Rejected("topping", f"nothing stays on {cover.spec.name}")
        drawn.append(fitting)
    return tuple(sorted(drawn, key=lambda spec: math.prod(spec.size), reverse=True))
