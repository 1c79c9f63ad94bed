"""Tasks with several like covers: are they there, and are they what the question names?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.side_by_side import COVERS
from probe.tasks.english import plural
from probe.tasks.task import Task
from probe.verification.subjects import spec_of, subject_is


def covers_of(task: Task) -> tuple[int, ...]:
    """Instances of the like covers."""
    assert task.cover is not None
    return task.scene.like(task.cover)


def covers_slot(task: Task, library: Library) -> Mapping[str, str]:
    """What fills the slot of wordings that name the covers."""
    assert task.cover is not None
    return {"covers": str(plural(spec_of(task, task.cover, library).name))}


def like_covers_problems(task: Task, library: Library) -> Iterator[str]:
    """That there are as many covers as wordings say, and that the subject is their name."""
    assert task.cover is not None
    if (count := len(covers_of(task))) != COVERS:
        yield f"there are {count} like covers, not {COVERS}"
    yield from subject_is(task, spec_of(task, task.cover, library).name)
