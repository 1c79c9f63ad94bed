"""How frozen tasks of Memory are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.side_by_side import COVERS
from probe.tasks.english import listed
from probe.tasks.task import Task
from probe.tasks.truth import beneath_each, which_beneath
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.side_by_side import hiding_problems
from probe.verification.subjects import spec_of, subject_is
from probe.verification.type_verifier import Makeup, Verifier


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    names = [spec_of(task, number, library).name for number in task.named]
    return {"names": listed(names), "cover": _asked(task, library)}


def _asked(task: Task, library: Library) -> str:
    """Name of the cover that it asks about."""
    assert task.cover is not None
    return spec_of(task, task.cover, library).name


def _subject(task: Task, library: Library) -> Iterator[str]:
    if len(task.named) != COVERS or len(set(task.named)) < COVERS or task.cover not in task.named:
        yield f"it doesn't name {COVERS} things to remove, with the one that it asks about"
    if set(task.named) & set(task.targets):
        yield "it names the hidden one"
    yield from sides_problems(task, library)
    others = [spec_of(task, it, library).name for it in task.named if it != task.cover]
    yield from subject_is(task, ", ".join([_asked(task, library), *others]))


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from hiding_problems(task, anew, task.named)
    under = beneath_each(task.named, anew.silhouettes)
    if task.cover is not None and under.get(task.cover) != task.targets:
        yield f"under cover {task.cover} lie {under.get(task.cover)}, not {task.targets}"
    hidden = [task.scene[number].object_id for each in under.values() for number in each]
    if not set(hidden) <= set(task.certificate.candidates):
        yield "what is under one of the covers is none of the candidates"
    yield from necessary_problems(task, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    drawn, shapes = task.certificate.candidates, anew.silhouettes
    assert task.cover is not None
    return anew.library[which_beneath(task.scene, drawn, task.cover, shapes).object_id].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), cover=True, named=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
