"""How frozen tasks of Find are checked."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.necessary import is_answerable_at_sight
from probe.generation.visibility_rules import is_clear, is_hidden, is_partly_visible
from probe.tasks.task import Task
from probe.verification.options import depth_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import no_slots, no_subject
from probe.verification.truth import candidate_on_table
from probe.verification.type_verifier import Makeup, Verifier


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from depth_problems(task, library)
    yield from no_subject(task, library)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    seen = anew.seen[task.targets[0]]
    rule, wanted = is_hidden, "hidden"
    if task.certificate.measures["partly"]:
        rule, wanted = is_partly_visible, "a little"
    elif is_answerable_at_sight(task):
        rule, wanted = is_clear, "in plain view"
    if not rule(seen):
        yield f"the answer shows by {seen.fraction:.0%}, which isn't {wanted}"


VERIFIER = Verifier(
    makeup=Makeup(1, measures=("partly",)),
    slots=no_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=candidate_on_table,
)
