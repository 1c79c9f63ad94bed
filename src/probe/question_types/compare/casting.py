"""Who plays in Compare, and how they lie beneath covers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import islice

import numpy as np

from probe.assets.library import Library
from probe.generation.marked import (
    CoveredThing,
    MarkedSelection,
    MarkedStage,
    cast_marked,
    markable,
)
from probe.generation.paint_twins import PaintTwins, paint_twins
from probe.generation.palettes import has_one_main_colour
from probe.generation.result import Rejected
from probe.generation.task_plan import CROSSED, TaskPlan
from probe.generation.twin_pairs import ColourQuestion, draw_duels
from probe.generation.twin_placement import aim_unpainted, draw_unpainted
from probe.tasks.task import AIM_RULES, PAIR

_CASTS = 6
"""How many an attempt tries, at most."""


def select_compare(
    library: Library, plan: TaskPlan, rng: np.random.Generator
) -> tuple[ColourQuestion, MarkedSelection]:
    """What is asked, and who plays.

    Raises:
        Rejected: The library has no paint twins that do, nothing to cover them, or no crowd.
    """
    return next(_casts(library, plan, rng))


def _casts(
    library: Library, plan: TaskPlan, rng: np.random.Generator
) -> Iterator[tuple[ColourQuestion, MarkedSelection]]:
    """All that come to mind; see select_compare()."""
    twins, aims = paint_twins_of(library), plan.rules >= AIM_RULES
    covered = uncovered = False
    if len({each.pair[0].category for each in twins}) < len(PAIR):
        mine = " of your own" if library.leading else ""
        raise Rejected("paint twins", f"{len(twins)} pairs of things{mine} differ in paint alone")
    for duel in draw_duels(library, twins, plan.form, rng):
        asked = duel.asked(plan)
        needed, too = [asked.reference] if asked.reference else [], asked.twins
        shown = (*asked.marked, *too, *needed)
        if aims and not all(has_one_main_colour(library, spec.id) for spec in shown):
            continue
        if cast := cast_marked(library, asked.marked, needed, rng, unlike_too=too, closed=aims):
            covered = True
            yield asked, cast
        uncovered = True
    if covered:
        return
    if uncovered:
        raise Rejected("cover", "no two things cover any pair that could be asked about")
    raise Rejected("candidates", f"no pair can be asked about in the form {plan.form!r}")


@lru_cache(maxsize=4)
def paint_twins_of(library: Library) -> tuple[PaintTwins, ...]:
    """All paint twins among what may be marked; where things lead, among those alone."""
    pool = markable(library)
    return paint_twins(library, filter(library.leads, pool) if library.leading else pool)


def draw_covered(
    library: Library,
    plan: TaskPlan,
    rng: np.random.Generator,
    stage: Callable[[MarkedSelection], MarkedStage],
) -> tuple[ColourQuestion, MarkedStage, tuple[CoveredThing, CoveredThing]]:
    """Both things beneath covers so that nothing shows of them but what their paint twins share.

    By newer rules several casts are tried: some things never show so under some covers.

    Args:
        library: To choose from.
        plan: Of the task.
        rng: Draws who plays and how they lie.
        stage: Makes the set of a cast.

    Raises:
        Rejected: None that was tried does.
    """
    aims = plan.rules >= AIM_RULES
    draw, failure = (aim_unpainted if aims else draw_unpainted), None
    for asked, cast in islice(_casts(library, plan, rng), _CASTS if aims else 1):
        made = stage(cast)
        try:
            nests = draw(made, twins_of(asked), library, asked.facing, more_of_a(plan), rng)
        except Rejected as rejected:
            failure = rejected
        else:
            return asked, made, nests
    assert failure is not None  # without any cast, _casts() raises
    raise failure


def twins_of(asked: ColourQuestion) -> tuple[str, str]:
    """Object ids of the paint twins of A and of B."""
    a, b = asked.twins
    return a.id, b.id


def more_of_a(plan: TaskPlan) -> bool:
    """Whether more pixels of A are to show than of B."""
    return CROSSED.of(plan)[2] == (plan.letter == PAIR[0])
