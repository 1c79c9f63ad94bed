"""How frozen tasks of Decoys are checked."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import is_hidden
from probe.question_types.decoys.truth import which_under_any
from probe.tasks.task import Task
from probe.verification.like_covers import (
    covers_of,
    covers_slot,
    like_covers_problems,
)
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.side_by_side import hiding_problems
from probe.verification.type_verifier import Makeup, Verifier


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from like_covers_problems(task, library)
    yield from sides_problems(task, library)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    if not is_hidden(anew.seen[task.targets[0]]):
        yield f"the answer shows by {anew.seen[task.targets[0]].fraction:.0%}"
    yield from hiding_problems(task, anew, covers_of(task))
    yield from necessary_problems(task, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    drawn, shapes = task.certificate.candidates, anew.silhouettes
    return anew.library[
        which_under_any(task.scene, drawn, covers_of(task), shapes)[0].object_id
    ].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), cover=True),
    slots=covers_slot,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
