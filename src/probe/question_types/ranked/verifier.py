"""How frozen tasks of Ranked are checked."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.alike import is_lying
from probe.generation.likeness import longest
from probe.generation.necessary import NECESSARY
from probe.generation.shown import LEVEL, SHOWN_LONGER, height_spread, least_step
from probe.generation.visibility_rules import is_hidden
from probe.question_types.ranked.ladder import looks_ordered
from probe.question_types.ranked.rules import RANKS
from probe.question_types.ranked.truth import has_rank, longest_first
from probe.tasks.task import Task
from probe.tasks.truth import on_top
from probe.verification.like_covers import (
    covers_of,
    covers_slot,
    like_covers_problems,
)
from probe.verification.necessary import necessary_problems
from probe.verification.remeasure import Remeasurement
from probe.verification.side_by_side import hiding_problems
from probe.verification.subjects import spec_of
from probe.verification.type_verifier import Makeup, Verifier


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from like_covers_problems(task, library)
    hidden = [spec_of(task, number, library) for number in task.targets]
    if not all(map(is_lying, hidden)) or not looks_ordered(hidden):
        yield "one of the hidden things may look longer than a longer one"
    asked, *others = (longest(spec) for spec in hidden)
    if not has_rank(task.form, asked, others):
        yield f"by the catalogue's sizes, {hidden[0].name} isn't the {task.form} one"


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    for number in task.targets:
        if not is_hidden(anew.seen[number]):
            yield f"{number}, which is to be hidden, shows by {anew.seen[number].fraction:.0%}"
    yield from hiding_problems(task, anew, covers_of(task))
    covers, shapes = covers_of(task), anew.silhouettes
    spread = height_spread(shapes, covers)
    if spread > LEVEL:
        yield f"one cover stands {1000 * spread:.0f} mm higher than another"
    gone = {*covers, *(above for cover in covers for above in on_top(cover, shapes))}
    bare = anew.view.labels(task.scene.without(*gone))
    sizes = {it: longest(spec_of(task, it, anew.library)) for it in task.targets}
    order = sorted(task.targets, key=lambda number: sizes[number], reverse=True)
    if (step := least_step(bare, order)) < SHOWN_LONGER:
        yield f"without the covers one thing looks only {step:.2f} times as long as the next"
    yield from necessary_problems(task, anew)


def _true_text(task: Task, anew: Remeasurement) -> str:
    lengths = {spec.id: longest(spec) for spec in anew.library.specs}
    found = longest_first(task.scene, covers_of(task), anew.silhouettes, lengths)
    return anew.library[found[RANKS.index(task.form)][0].object_id].name


VERIFIER = Verifier(
    makeup=Makeup(len(RANKS), measures=(NECESSARY,), cover=True),
    slots=covers_slot,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
)
