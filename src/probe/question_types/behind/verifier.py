"""How frozen tasks of Behind are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.question_types.behind.judge import hidden_by, seen_from_above
from probe.question_types.behind.truth import which_behind
from probe.tasks.task import Task
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is
from probe.verification.type_verifier import Makeup, Verifier
from probe.verification.uncovering import uncovering_problems


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    assert task.cover is not None
    return {"occluder": spec_of(task, task.cover, library).name}


def _subject(task: Task, library: Library) -> Iterator[str]:
    assert task.cover is not None
    if task.cover in task.targets:
        yield "what stands in front and what is behind are the same"
    if task.camera != "front":
        yield f"the {task.camera} camera shows it, which sees behind things"
    yield from subject_is(task, spec_of(task, task.cover, library).name)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,), occluder = task.targets, task.cover
    assert occluder is not None
    if not is_hidden(anew.seen[target]):
        yield f"the answer shows by {anew.seen[target].fraction:.0%}"
    if not is_clear(anew.seen[occluder]):
        yield f"only {anew.seen[occluder].fraction:.0%} of what stands in front show"
    alone = hidden_by(anew.view, anew.scene, target, occluder)
    if not is_hidden(alone):
        yield f"behind the occluder alone it shows by {alone.fraction:.0%}"
    above = seen_from_above(anew.view, anew.scene, target)
    if not is_clear(above):
        yield f"something lies on it: only {above.fraction:.0%} show from above"
    for how, after in anew.removals([occluder]):
        yield from uncovering_problems(f"without the occluder ({how})", after, target, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    assert task.cover is not None
    scene, drawn = task.scene, task.certificate.candidates
    known = [o.instance for o in scene.objects if o.object_id in drawn]
    shapes = anew.view.silhouettes(scene, [*known, task.cover])
    found = which_behind(scene, drawn, task.cover, shapes, anew.view.camera)
    return anew.library[found.object_id].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=("above_share",), cover=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
