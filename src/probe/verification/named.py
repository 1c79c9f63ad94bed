"""Of tasks that name what is to be removed: shared by the verifiers of Reduce and Exact."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.tasks.english import listed
from probe.tasks.task import Task
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is


def named_slots(task: Task, library: Library) -> Mapping[str, str]:
    """What fills the slots of their wordings."""
    return {"names": listed(_named(task, library))}


def named_problems(task: Task, library: Library) -> Iterator[str]:
    """That a task names things once each, none of them hidden, and has them as its subject."""
    if len(set(task.named)) < len(task.named) or set(task.named) & set(task.targets):
        yield "it names a thing twice, or the hidden one"
    yield from subject_is(task, ", ".join(_named(task, library)))


def shown_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """That the hidden thing is hidden, and what is named is clear."""
    (target,) = task.targets
    if not is_hidden(anew.seen[target]):
        yield f"the answer shows by {anew.seen[target].fraction:.0%}"
    for number in task.named:
        if not is_clear(anew.seen[number]):
            yield f"only {anew.seen[number].fraction:.0%} of {number}, which is named, show"


def _named(task: Task, library: Library) -> list[str]:
    return [spec_of(task, number, library).name for number in task.named]
