"""How frozen tasks of Nested are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import HIDDEN_SHARE, is_hidden, is_seen
from probe.question_types.nested.truth import which_nested
from probe.tasks.task import Task
from probe.tasks.truth import on_top
from probe.verification.necessary import necessary_problems
from probe.verification.options import sides_problems
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
    yield from sides_problems(task, library)
    yield from subject_is(task, spec_of(task, task.cover, library).name)


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,), outer = task.targets, task.cover
    assert outer is not None
    try:
        inner = _stack(task, anew)[1]
    except ValueError:
        return  # said by the check of the truth
    for number, what in ((target, "answer"), (inner, "inner cover")):
        if not is_hidden(anew.seen[number]):
            yield f"the {what} shows by {anew.seen[number].fraction:.0%}"
    if not is_seen(anew.seen[outer]):
        yield f"only {anew.seen[outer].fraction:.0%} of the cover show"
    above = on_top(outer, anew.silhouettes)
    for how, after in anew.removals([outer, *above]):
        when = f"without its cover ({how})"
        yield from uncovering_problems(when, after, inner, anew, "the inner cover")
        if after[target].fraction > HIDDEN_SHARE:
            share = after[target].fraction
            yield f"without the outer cover alone ({how}) the answer shows by {share:.0%}"
    for how, after in anew.removals([outer, inner, *above]):
        yield from uncovering_problems(f"without both covers ({how})", after, target, anew)
    yield from necessary_problems(task, anew)


def _stack(task: Task, anew: Remeasurement) -> tuple[str, int]:
    """Object id of what is at the bottom, and the instance between it and the cover.

    Raises:
        ValueError: There aren't exactly such two.
    """
    assert task.cover is not None
    drawn, shapes = task.certificate.candidates, anew.silhouettes
    found, inner = which_nested(task.scene, drawn, task.cover, shapes)
    return found.object_id, inner


def _true_text(task: Task, anew: Remeasurement) -> str:
    return anew.library[_stack(task, anew)[0]].name


VERIFIER = Verifier(
    makeup=Makeup(1, measures=(NECESSARY,), cover=True),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
