"""Who plays in Budgeted: something long, four shorter things, and five covers over them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import draw_alike, is_lying, unlike
from probe.generation.covers import Cover, draw_cover, footprint_of
from probe.generation.likeness import TWIN_TOLERANCE, Likeness, longest, told_apart
from probe.generation.object_selection import ObjectSelection, hideable
from probe.generation.result import Rejected
from probe.generation.side_by_side import Hidden, liftable, select
from probe.generation.task_plan import TaskPlan
from probe.question_types.budgeted.sizes import RULED_OUT, too_small
from probe.scene.turns import in_turn
from probe.tasks.options import CANDIDATES
from probe.tasks.truth import LONGER

WIDE, SMALL = 3, 2
"""Covers that have room for what is asked for, and covers that don't."""

SHORTEST, LONGEST = 0.086, 0.105
"""Length in metres of what is asked for: some covers have room for it, and some are too small."""

NEEDS = (
    f"{CANDIDATES} things {100 * SHORTEST:g} to {100 * LONGEST:g} cm long, lying, alike in length "
    f"to {TWIN_TOLERANCE:.0%}, {WIDE + SMALL - 1} that are shorter by "
    f"{LONGER - 1:.0%}, all unlike in name and colour; {WIDE} hollow covers with room for any of "
    f"these, and {SMALL} that are too small for the long ones"
)
"""For people."""

_EASY = 0.114
"""Narrow side in metres of a cover, at most. Wider ones barely fit between the fingers, so that the
hand often touches them and stops; and tries are few."""

_MARGIN = 0.008
"""Metres by which a wide cover's narrow side is longer than what it hides, walls included."""

_TINY = 0.06
"""Diagonal on the table in metres of what lies under a small cover, at most."""

_FEWEST, _MOST = 3, 5
"""Things around the covers."""


def select_budgeted(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Five long things of which one is there, four short ones, three wide covers, two small ones.

    Raises:
        Rejected: The library has no such set.
    """

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        return _covers(library, free, hidden, rng)

    crowd = int(rng.integers(_FEWEST, _MOST + 1))
    return select(library, draw, crowd, rng, _hidden)


def _hidden(library: Library, rng: np.random.Generator) -> Hidden:
    """Draw what lies beneath: five alike, and things clearly shorter, the tiniest ones last.

    The five may be of any width and height: covers stand on the table, over whatever is there.

    Raises:
        Rejected: The library has too few.
    """
    candidates = draw_alike(
        [it for it in hideable(library, LONGEST) if longest(it) >= SHORTEST and is_lying(it)],
        library.specs,
        Likeness(TWIN_TOLERANCE, whole_names=True),
        CANDIDATES,
        rng,
        leads=library.leads,
    )
    length = min(map(longest, candidates))
    free = [spec for spec in unlike(hideable(library), candidates) if is_lying(spec)]
    order = in_turn([it for it in free if _is_shorter(it, length)], library.leads, rng)
    tiny = _first(SMALL, [spec for spec in order if _diagonal(spec) <= _TINY])
    short = _first(WIDE - 1, unlike(order, tiny))
    if len(tiny) < SMALL or len(short) < WIDE - 1:
        raise Rejected("candidates", f"only {len(short)} shorter and {len(tiny)} tiny things")
    room = tuple(footprint_of(library, spec.id) for spec in (*candidates, *short, *tiny))
    return Hidden(candidates, (*short, *tiny), room)


def _first(count: int, order: Sequence[ObjectSpec]) -> tuple[ObjectSpec, ...]:
    """The first that can be told apart, so many at most."""
    drawn: list[ObjectSpec] = []
    for spec in order:
        if len(drawn) < count and told_apart([*drawn, spec]):
            drawn.append(spec)
    return tuple(drawn)


def _is_shorter(spec: ObjectSpec, length: float) -> bool:
    """Whether a thing is clearly shorter, and its box too however it is turned."""
    return LONGER * longest(spec) <= length and _diagonal(spec) <= length


def _diagonal(spec: ObjectSpec) -> float:
    return math.hypot(*spec.size[:2])


def _covers(
    library: Library, free: Sequence[ObjectSpec], hidden: Hidden, rng: np.random.Generator
) -> Sequence[Cover]:
    """Wide and small covers, shuffled; fewer if there aren't so many."""
    shortest = min(map(longest, hidden.candidates))
    easy = [spec for spec in liftable(free) if min(spec.size[:2]) <= _EASY]
    hollow = [spec for spec in easy if spec.hollow]
    least = max(item.width for item in hidden.room[:-SMALL]) + _MARGIN
    wide = [spec for spec in hollow if min(spec.size[:2]) >= least]
    small = [spec for spec in hollow if max(spec.size[:2]) * RULED_OUT <= shortest]
    small = [spec for spec in small if too_small(library, spec.id, shortest)]
    covers: list[Cover] = []
    for pool, room in [
        *[(wide, hidden.room[:-SMALL])] * WIDE,
        *[(small, hidden.room[-SMALL:])] * SMALL,
    ]:
        fresh = unlike(pool, [cover.spec for cover in covers])
        cover = draw_cover(library, fresh, room, rng)
        # A cover that rests on what it hides tells how high that is.
        if cover is not None and cover.depth >= max(it.height for it in room):
            covers.append(cover)
    order: list[int] = rng.permutation(len(covers)).tolist()
    return [covers[number] for number in order]
