"""How frozen tasks of Exact are checked."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.tasks.task import Task
from probe.tasks.truth import lies_under
from probe.verification.named import named_problems, named_slots, shown_problems
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.truth import candidate_on_table
from probe.verification.type_verifier import Crossing, Makeup, Verifier
from probe.verification.uncovering import uncovering_problems


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from named_problems(task, library)
    yield from sides_problems(task, library)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,) = task.targets
    yield from shown_problems(task, anew)
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
    slots=named_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=candidate_on_table,
    crossed=(Crossing("removals", ("1", "2"), lambda task: str(len(task.named))),),
)
