"""How frozen tasks of Beneath are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.visibility_rules import is_hidden, is_seen
from probe.tasks.task import PILE_RULES, Task
from probe.tasks.truth import on_top, which_beneath
from probe.verification.options import depth_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is
from probe.verification.type_verifier import Makeup, Verifier
from probe.verification.uncovering import uncovering_problems


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    assert task.cover is not None
    return {"cover": spec_of(task, task.cover, library).name}


def _subject(task: Task, library: Library) -> Iterator[str]:
    assert task.cover is not None
    if task.cover in task.targets:
        yield "what covers and what is covered are the same"
    yield from depth_problems(task, library)
    yield from subject_is(task, spec_of(task, task.cover, library).name)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,), cover = task.targets, task.cover
    assert cover is not None
    if not is_hidden(anew.seen[target]):
        yield f"the answer shows by {anew.seen[target].fraction:.0%}"
    if not is_seen(anew.seen[cover]):
        yield f"only {anew.seen[cover].fraction:.0%} of the cover show"
    piled = task.version >= PILE_RULES
    above = on_top(cover, anew.silhouettes) if piled else ()
    for how, after in anew.removals([cover, *above]):
        yield from uncovering_problems(f"without its cover ({how})", after, target, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    assert task.cover is not None
    scene, drawn = task.scene, task.certificate.candidates
    known = [o.instance for o in scene.objects if o.object_id in drawn]
    shapes = anew.view.silhouettes(scene, [*known, task.cover])
    return anew.library[which_beneath(scene, drawn, task.cover, shapes).object_id].name


VERIFIER = Verifier(
    makeup=Makeup(1, cover=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
