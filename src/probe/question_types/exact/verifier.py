"""How frozen tasks of Exact are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.tasks.english import listed
from probe.tasks.task import Task
from probe.tasks.truth import lies_under
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is
from probe.verification.truth import candidate_on_table
from probe.verification.type_verifier import Crossing, Makeup, Verifier
from probe.verification.uncovering import uncovering_problems


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    return {"names": listed(_named(task, library))}


def _subject(task: Task, library: Library) -> Iterator[str]:
    if len(set(task.named)) < len(task.named) or set(task.named) & set(task.targets):
        yield "it names a thing twice, or the hidden one"
    yield from sides_problems(task, library)
    yield from subject_is(task, ", ".join(_named(task, library)))


def _named(task: Task, library: Library) -> list[str]:
    return [spec_of(task, number, library).name for number in task.named]


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,) = task.targets
    if not is_hidden(anew.seen[target]):
        yield f"the answer shows by {anew.seen[target].fraction:.0%}"
    for number in task.named:
        if not is_clear(anew.seen[number]):
            yield f"only {anew.seen[number].fraction:.0%} of {number}, which is named, show"
    shapes = anew.view.silhouettes(task.scene, [target, *task.named])
    over = [number for number in task.named if lies_under(shapes[target], shapes[number])]
    if len(over) != 1:
        yield f"the answer lies under {len(over)} of what is named, not under one"
        return
    for how, after in anew.removals(over):
        yield from uncovering_problems(f"without its cover ({how})", after, target, anew)
    yield from necessary_problems(task, anew)


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), named=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=candidate_on_table,
    crossed=(Crossing("removals", ("1", "2"), lambda task: str(len(task.named))),),
)
