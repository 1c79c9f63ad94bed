"""How frozen tasks of Relation are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.likeness import SIDES_TOLERANCE, sides_alike, told_apart
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import is_hidden
from probe.question_types.relation.truth import next_beneath
from probe.tasks.task import Task
from probe.tasks.truth import beneath_each
from probe.verification.like_covers import covers_of, covers_slot, like_covers_problems
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.side_by_side import hiding_problems
from probe.verification.subjects import spec_of
from probe.verification.type_verifier import Makeup, Verifier

_ROUNDING = 1e-9


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    return {**covers_slot(task, library), "name": spec_of(task, task.targets[1], library).name}


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from like_covers_problems(task, library)
    yield from sides_problems(task, library)
    named = spec_of(task, task.targets[1], library)
    drawn = [library[object_id] for object_id in task.certificate.candidates]
    if not told_apart([named, *drawn]):
        yield f"{named.name}, which it names, can't be told from a candidate"
    if not sides_alike([named, *drawn], SIDES_TOLERANCE + _ROUNDING):
        yield f"a side of {named.name}, which it names, differs by more than {SIDES_TOLERANCE:.0%}"


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    for number in task.targets:
        if not is_hidden(anew.seen[number]):
            yield f"{number}, which is to be hidden, shows by {anew.seen[number].fraction:.0%}"
    covers = covers_of(task)
    yield from hiding_problems(task, anew, covers)
    under = beneath_each(covers, anew.silhouettes).values()
    third = [number for each in under for number in each if number not in task.targets]
    if any(task.scene[it].object_id not in task.certificate.candidates for it in third):
        yield "what is under the third cover is none of the candidates"
    yield from necessary_problems(task, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    shapes = anew.silhouettes
    found, _ = next_beneath(task.scene, task.form, task.targets[1], covers_of(task), shapes)
    return anew.library[found.object_id].name


VERIFIER = Verifier(
    makeup=Makeup(2, measures=(NECESSARY,), cover=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
