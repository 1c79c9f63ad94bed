"""Who plays in Memory: five candidates, three unlike covers, and a small crowd."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import NEEDS_COVER, Cover
from probe.generation.likeness import TWIN_TOLERANCE
from probe.generation.object_selection import LARGEST, ObjectSelection, needs_alike
from probe.generation.side_by_side import COVERS, Hidden, draw_unlike_covers, select
from probe.generation.task_plan import TaskPlan

NEEDS = (
    f"{needs_alike(LARGEST, TWIN_TOLERANCE, sides=True)}; over any of them, {COVERS} times, "
    f"{NEEDS_COVER}, which can be lifted"
)
"""What a library must have, for people."""

_FEWEST, _MOST = 4, 6
"""Things around the covers."""


def select_memory(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Alike candidates, of which three lie beneath covers, and nothing else that is hidden.

    Raises:
        Rejected: The library has no such set.
    """

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        covers = draw_unlike_covers(library, free, hidden, rng)
        return covers if len(covers) == COVERS else []

    crowd = int(rng.integers(_FEWEST, _MOST + 1))
    hide = partial(Hidden.drawn, rules=plan.rules, secrets=0)
    return select(library, draw, crowd, rng, hide)
