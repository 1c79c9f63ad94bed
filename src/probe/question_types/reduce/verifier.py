"""How frozen tasks of Reduce are checked."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.visibility_rules import (
    CLEAR_SHARE,
    HIDDEN_SHARE,
    LARGEST_GAIN,
    PARTLY,
)
from probe.tasks.task import Task
from probe.verification.named import named_problems, named_slots, shown_problems
from probe.verification.options import depth_problems, level_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.truth import candidate_on_table
from probe.verification.type_verifier import Makeup, Verifier


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from named_problems(task, library)
    yield from depth_problems(task, library)
    yield from level_problems(task, library)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from shown_problems(task, anew)
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
    slots=named_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=candidate_on_table,
)
