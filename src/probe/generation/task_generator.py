"""What building a task needs of a question type. Knows none of the types."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from probe.assets.library import Library
from probe.generation.result import TaskCandidate
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.render.renderer import Renderer
from probe.tasks.registry import part_of

Generate = Callable[[int, TaskPlan, Library, Renderer, Sequence[str]], TaskCandidate]
"""Seed, plan, library, renderer and ids of tables to a candidate; raises Rejected."""

Select = Callable[[Library, TaskPlan, np.random.Generator], object]


@dataclass(frozen=True)
class TaskGenerator:
    """How tasks of a type are made; the part "generator" of a question type.

    Attributes:
        generate: One attempt, with all the type's checks.
        select: What it begins with: who plays. Raises Rejected with the reason why nobody can.
        needs: What that takes of a library, for people.
        turns: What the type is planned by beside its letter and its wording.
    """

    generate: Generate
    select: Select
    needs: str
    turns: tuple[PlannedProperty[Any], ...] = ()


def generator_of(question_type: str) -> TaskGenerator:
    """How tasks of a type are made.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: Its generator can't be used.
    """
    return part_of(question_type, "generator", TaskGenerator)
