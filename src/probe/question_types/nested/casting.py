"""Who plays in Nested: what is hidden, a cover over it, and another one over that. No physics."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import draw_alike, unlike
from probe.generation.covers import Cover, Footprint, draw_cover, footprint_of
from probe.generation.likeness import SIDES_TOLERANCE, TWIN_TOLERANCE, Likeness, whole_names_by
from probe.generation.object_selection import (
    CAST_TRIES,
    VARIED_TRIES,
    ObjectSelection,
    draw_crowd,
    hideable,
    needs_alike,
    those_to_hide,
)
from probe.generation.result import Rejected
from probe.generation.task_plan import TaskPlan
from probe.generation.toppings import is_topped, with_toppings
from probe.tasks.options import CANDIDATES
from probe.tasks.task import KIND_RULES
from probe.types import Pose

LARGEST = 0.07
"""Longest side in metres of what lies at the bottom: two things have to lie over it."""

NEEDS = needs_alike(LARGEST, TWIN_TOLERANCE, sides=True)

_FEWEST, _MOST = 10, 13


def select_nested(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Five candidates, something that covers any of them, and something that covers both.

    Raises:
        Rejected: The library has no such set.
    """
    count = int(rng.integers(_FEWEST, _MOST + 1))
    whole = whole_names_by(plan.rules)
    likeness = Likeness(TWIN_TOLERANCE, SIDES_TOLERANCE, whole_names=whole)
    failure = Rejected("cover", "nothing was drawn")
    for number in range(CAST_TRIES):
        candidates = draw_alike(
            hideable(library, LARGEST),
            library.specs,
            likeness,
            CANDIDATES,
            rng,
            varied=plan.rules >= KIND_RULES and number < VARIED_TRIES,
            leads=library.leads,
        )
        room = [footprint_of(library, spec.id) for spec in candidates]
        free = unlike(library.specs, candidates)
        if not (covers := _covers(library, free, room, rng)):
            names = ", ".join(spec.name for spec in candidates)
            failure = Rejected("cover", f"no two covers, one for the other, for {names}")
            continue
        try:
            eligible = those_to_hide(library, candidates, covers)
        except Rejected as rejected:
            failure = rejected
            continue
        free = unlike(free, [cover.spec for cover in covers])
        others = draw_crowd(free, count - 1 - len(covers), rng)
        cast = ObjectSelection(candidates, eligible, covers, others)
        return with_toppings(library, cast, [len(covers) - 1], rng) if is_topped(plan) else cast
    raise failure


def _covers(
    library: Library, free: list[ObjectSpec], room: Sequence[Footprint], rng: np.random.Generator
) -> tuple[Cover, ...]:
    """An inner cover and one that hides it; none if there are no such two."""
    inner = draw_cover(library, free, room, rng)
    if inner is None:
        return ()
    outer = draw_cover(library, unlike(free, [inner.spec]), [lying(library, inner, room)], rng)
    return (inner, outer) if outer else ()


def lying(library: Library, cover: Cover, room: Sequence[Footprint]) -> Footprint:
    """Room that a cover needs where it lies over the highest of some things."""
    corners = Pose(wxyz=cover.wxyz).apply(library.form(cover.spec.id).mesh.vertices)[:, :2]
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    width = 2 * float(np.linalg.norm(corners - middle, axis=1).max())
    lifted = max(0.0, max(item.height for item in room) - cover.depth)
    return Footprint(width, cover.extent[2] + lifted)
