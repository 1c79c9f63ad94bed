"""How frozen tasks of Budgeted are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import cover_of
from probe.generation.likeness import longest
from probe.generation.necessary import NECESSARY
from probe.question_types.budgeted.casting import SMALL, WIDE
from probe.question_types.budgeted.judge import LIFTED
from probe.question_types.budgeted.rules import MANIPULATIONS
from probe.question_types.budgeted.sizes import told_length, too_small
from probe.question_types.budgeted.truth import which_is_so_long
from probe.tasks.english import listed
from probe.tasks.task import Task
from probe.verification.necessary import necessary_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.side_by_side import hiding_problems
from probe.verification.subjects import instances_called, spec_of
from probe.verification.type_verifier import Makeup, Verifier


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    names = [spec_of(task, number, library).name for number in _covers(task, library)]
    return {"covers": listed(names), "length": told_length(_candidates(task, library))}


def _covers(task: Task, library: Library) -> Sequence[int]:
    """Instances of what the subject names, in its order."""
    names = task.subject.split(", ")
    return [number for name in names for number in instances_called(name, task, library)]


def _candidates(task: Task, library: Library) -> Sequence[ObjectSpec]:
    return [library[object_id] for object_id in task.certificate.candidates]


def _subject(task: Task, library: Library) -> Iterator[str]:
    covers = _covers(task, library)
    if len(covers) != WIDE + SMALL or task.cover not in covers:
        yield f"its subject is {ascii(task.subject)}, not five covers of which one is its own"
    shortest = min(map(longest, _candidates(task, library)))
    ids = [task.scene[number].object_id for number in covers]
    small = sum(too_small(library, object_id, shortest) for object_id in ids)
    if small != SMALL:
        yield f"{small} of the covers are too small for what is asked for, not {SMALL}"


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    covers = _covers(task, anew.library)
    yield from hiding_problems(task, anew, covers)
    shapes = anew.silhouettes
    for number in covers:
        cover = cover_of(anew.library, task.scene[number].object_id)
        if cover is None or shapes[number].top - cover.extent[2] > LIFTED:
            yield f"cover {number} doesn't stand on the table"
    yield from necessary_problems(task, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    lengths = {spec.id: longest(spec) for spec in anew.library.specs}
    sizes = [longest(spec) for spec in _candidates(task, anew.library)]
    covers, shapes = _covers(task, anew.library), anew.silhouettes
    between = (min(sizes), max(sizes))
    found, _ = which_is_so_long(task.scene, covers, shapes, lengths, between)
    return anew.library[found.object_id].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), cover=True, manipulations=MANIPULATIONS),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
