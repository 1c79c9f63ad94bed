"""One attempt to make a task of a given type, from numbers alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.beneath import generate_beneath, select_beneath
from probe.generation.compare import generate_compare, select_compare
from probe.generation.count import generate_count, select_count
from probe.generation.find import generate_find, select_find
from probe.generation.plan import TaskPlan
from probe.generation.reduce import generate_reduce, select_reduce
from probe.generation.result import Rejected, Rejection, TaskCandidate
from probe.generation.size import generate_size, select_size
from probe.render.renderer import Renderer
from probe.tasks.task import QuestionType

Generator = Callable[[int, TaskPlan, Library, Renderer, Sequence[str]], TaskCandidate]

GENERATORS: dict[QuestionType, Generator] = {
    "beneath": generate_beneath,
    "compare": generate_compare,
    "count": generate_count,
    "find": generate_find,
    "reduce": generate_reduce,
    "size": generate_size,
}

Selector = Callable[[Library, TaskPlan, np.random.Generator], object]

SELECTORS: dict[QuestionType, Selector] = {
    "beneath": select_beneath,
    "compare": select_compare,
    "count": select_count,
    "find": select_find,
    "reduce": select_reduce,
    "size": select_size,
}
"""What each generator begins with: who plays, or the reason why nobody can."""


def generate(
    question_type: QuestionType,
    seed: int,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
) -> TaskCandidate | Rejection:
    """One attempt at a public task; see make().

    Args:
        question_type: The type.
        seed: Of this attempt; seeds with the same thousands belong to one episode (see plan()).
        library: As in make().
        renderer: As in make().
        tables: As in make().
    """
    return make(Attempt.of_seed(question_type, seed), library, renderer, tables)


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
    generator = GENERATORS[attempt.place.question_type]
    try:
        made = generator(attempt.seed, attempt.plan, library, renderer, tables)
    except Rejected as failure:
        return failure.rejection
    return attempt.named(made)
