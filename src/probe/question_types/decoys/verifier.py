"""How frozen tasks of Decoys are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.side_by_side import COVERS
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.question_types.decoys.truth import which_under_any
from probe.tasks.english import plural
from probe.tasks.task import Task
from probe.tasks.truth import lies_under
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is
from probe.verification.type_verifier import Makeup, Verifier
from probe.verification.uncovering import uncovering_problems


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    assert task.cover is not None
    return {"covers": str(plural(spec_of(task, task.cover, library).name))}


def _subject(task: Task, library: Library) -> Iterator[str]:
    assert task.cover is not None
    if (count := len(_covers(task))) != COVERS:
        yield f"there are {count} like covers, not {COVERS}"
    yield from sides_problems(task, library)
    yield from subject_is(task, spec_of(task, task.cover, library).name)


def _covers(task: Task) -> tuple[int, ...]:
    assert task.cover is not None
    return task.scene.like(task.cover)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    if not is_hidden(anew.seen[task.targets[0]]):
        yield f"the answer shows by {anew.seen[task.targets[0]].fraction:.0%}"
    numbers = [placed.instance for placed in task.scene.objects]
    shapes = anew.view.silhouettes(task.scene, numbers)
    for cover in _covers(task):
        under = [n for n in numbers if n != cover and lies_under(shapes[n], shapes[cover])]
        if len(under) != 1:
            yield f"{len(under)} things lie under cover {cover}"
            continue
        yield from _covered(cover, under[0], anew)
    yield from necessary_problems(task, anew)


def _covered(cover: int, item: int, anew: Remeasurement) -> Iterator[str]:
    """That a thing is hidden, and that its cover alone hides it."""
    if not is_hidden(anew.seen[item]):
        yield f"what is under cover {cover} shows by {anew.seen[item].fraction:.0%}"
    if not is_clear(anew.seen[cover]):
        yield f"only {anew.seen[cover].fraction:.0%} of cover {cover} show"
    for how, after in anew.removals([cover]):
        when = f"without cover {cover} ({how})"
        yield from uncovering_problems(when, after, item, anew, "what it hides")


def _true_text(task: Task, anew: Remeasurement) -> str:
    drawn, covers = task.certificate.candidates, _covers(task)
    known = [o.instance for o in task.scene.objects if o.object_id in drawn]
    shapes = anew.view.silhouettes(task.scene, [*known, *covers])
    return anew.library[which_under_any(task.scene, drawn, covers, shapes)[0].object_id].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), cover=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
