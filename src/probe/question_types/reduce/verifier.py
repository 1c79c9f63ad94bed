"""How frozen tasks of Reduce are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.visibility_rules import (
    CLEAR_SHARE,
    HIDDEN_SHARE,
    LARGEST_GAIN,
    PARTLY,
    is_clear,
    is_hidden,
)
from probe.tasks.english import listed
from probe.tasks.task import Task
from probe.verification.options import depth_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import spec_of, subject_is
from probe.verification.truth import candidate_on_table
from probe.verification.type_verifier import Makeup, Verifier


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    return {"names": listed(_named(task, library))}


def _subject(task: Task, library: Library) -> Iterator[str]:
    if len(set(task.named)) < len(task.named) or set(task.named) & set(task.targets):
        yield "it names a thing twice, or the hidden one"
    yield from depth_problems(task, library)
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
    yield from _all_removed(task, anew)
    yield from _one_removed(task, anew)


def _all_removed(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,) = task.targets
    hidden = [n for n, v in anew.seen.items() if v.fraction <= HIDDEN_SHARE and n != target]
    for how, after in anew.removals(task.named):
        if after[target].fraction < CLEAR_SHARE:
            yield f"at the end ({how}) only {after[target].fraction:.0%} of it show"
        if any(after[n].fraction > LARGEST_GAIN for n in hidden if n in after):
            yield f"at the end ({how}) another hidden thing shows"


def _one_removed(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,) = task.targets
    for number in task.named if len(task.named) > 1 else ():
        for how, after in anew.removals([number]):
            if after[target].fraction > PARTLY[1]:
                yield f"it shows by {after[target].fraction:.0%} without {number} alone ({how})"


VERIFIER = Verifier(
    makeup=Makeup(1, named=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=candidate_on_table,
)
