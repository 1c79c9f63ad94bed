"""One attempt to make a task of a given type, from numbers alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.beneath import cast_beneath, generate_beneath
from probe.generation.compare import cast_compare, generate_compare
from probe.generation.count import cast_count, generate_count
from probe.generation.find import cast_find, generate_find
from probe.generation.plan import TaskPlan
from probe.generation.reduce import cast_reduce, generate_reduce
from probe.generation.result import Rejected, Rejection, TaskCandidate
from probe.generation.size import cast_size, generate_size
from probe.render.renderer import Renderer
from probe.tasks.task import QuestionKind

Generator = Callable[[int, TaskPlan, Library, Renderer, Sequence[str]], TaskCandidate]

GENERATORS: dict[QuestionKind, Generator] = {
    "beneath": generate_beneath,
    "compare": generate_compare,
    "count": generate_count,
    "find": generate_find,
    "reduce": generate_reduce,
    "size": generate_size,
}

Casting = Callable[[Library, TaskPlan, np.random.Generator], object]

CASTINGS: dict[QuestionKind, Casting] = {
    "beneath": cast_beneath,
    "compare": cast_compare,
    "count": cast_count,
    "find": cast_find,
    "reduce": cast_reduce,
    "size": cast_size,
}
"""What each generator begins with: who plays, or the reason why nobody can."""


def generate(
    kind: QuestionKind, seed: int, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate | Rejection:
    """One attempt at a public task; see make().

    Args:
        kind: The type.
        seed: Of this attempt; seeds with the same thousands belong to one episode (see plan()).
        library: As in make().
        renderer: As in make().
        tables: As in make().
    """
    return make(Attempt.of_seed(kind, seed), library, renderer, tables)


def make(
    attempt: Attempt, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate | Rejection:
    """Make a scene for a question and check it; the same attempt gives the same.

    Args:
        attempt: Which task is tried, and what it is made from.
        library: Objects to choose from.
        renderer: Measures visibility; what was loaded in it is replaced.
        tables: Ids of table materials to choose from.
    """
    generator = GENERATORS[attempt.place.kind]
    try:
        made = generator(attempt.seed, attempt.plan, library, renderer, tables)
    except Rejected as failure:
        return failure.rejection
    return attempt.named(made)
