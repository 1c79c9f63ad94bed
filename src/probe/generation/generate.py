"""One attempt to make a task of a given type, from numbers alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.necessary import NECESSARY, view_of, with_necessary
from probe.generation.result import Rejected, Rejection, TaskCandidate
from probe.generation.task_generator import generator_of
from probe.render.renderer import Renderer
from probe.tasks.task import STEP_RULES, QuestionType


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
    generator = generator_of(attempt.place.question_type)
    try:
        made = generator.generate(attempt.seed, attempt.plan, library, renderer, tables)
        if attempt.rules >= STEP_RULES and NECESSARY not in made.task.certificate.measures:
            view = view_of(made.task, library, renderer)
            made = replace(made, task=with_necessary(made.task, view, library))
    except Rejected as failure:
        return failure.rejection
    return attempt.named(made)
