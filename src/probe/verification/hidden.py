"""Is the answer hidden, and does it come to light as its type's rule says? Measured anew."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from scipy import ndimage

from probe.generation.marked import INSIDE_PX
from probe.generation.paint_twins import ALIKE
from probe.generation.result import Rejected
from probe.generation.size_cues import VisiblePatch, are_within, leads_of
from probe.generation.twin_placement import shared
from probe.generation.twin_worlds import CompareQuestion
from probe.generation.visibility_rules import (
    CLEAR_SHARE,
    HIDDEN_SHARE,
    LARGEST_GAIN,
    LITTLE,
    PARTLY,
    REVEALED_SHARE,
    is_clear,
    is_hidden,
    is_partly_visible,
    is_seen,
)
from probe.tasks.task import PAIR, Mark, QuestionType, Task
from probe.verification.remeasure import Remeasurement

_SAME = 0.02
_SAME_PX = 40
"""How far pixels may differ from the certificate's on another kind of machine: by share, or few."""

_SAME_COLOUR = 1.0
"""How far colours may, CIEDE2000 or L*: less than an eye sees side by side."""


def hidden_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What is wrong with what shows of a task's first picture and after ghost removal."""
    for number, stated in task.certificate.visibility.items():
        found = anew.seen[number].visible_px
        if abs(found - stated.visible_px) > max(_SAME * stated.visible_px, _SAME_PX):
            yield f"{found} px of object {number} show, not {stated.visible_px}"
    yield from _RULES[task.question_type](task, anew)


def _beneath(task: Task, anew: Remeasurement) -> Iterator[str]:
    (target,), cover = task.targets, task.cover
    assert cover is not None
    if not is_hidden(anew.seen[target]):
        yield f"the answer shows by {anew.seen[target].fraction:.0%}"
    if not is_seen(anew.seen[cover]):
        yield f"only {anew.seen[cover].fraction:.0%} of the cover show"
    for how, after in anew.removals([cover]):
        if after[target].fraction < REVEALED_SHARE:
            yield f"without its cover ({how}) only {after[target].fraction:.0%} of it show"
        gains = [after[n].fraction - anew.seen[n].fraction for n in after if n != target]
        if max(gains, default=0.0) > LARGEST_GAIN:
            yield f"without the cover ({how}) another thing gains {max(gains):.0%}"


def _count(task: Task, anew: Remeasurement) -> Iterator[str]:
    shown = [anew.seen[number] for number in task.targets]
    clear, hidden = sum(map(is_clear, shown)), sum(map(is_hidden, shown))
    measures = task.certificate.measures
    if (clear, hidden) != (measures["clear"], measures["hidden"]):
        yield f"{clear} are clear and {hidden} hidden"
    if clear + hidden != len(shown):
        yield "one is neither clear nor hidden"


def _find(task: Task, anew: Remeasurement) -> Iterator[str]:
    seen = anew.seen[task.targets[0]]
    partly = bool(task.certificate.measures["partly"])
    if not (is_partly_visible if partly else is_hidden)(seen):
        wanted = "a little" if partly else "hidden"
        yield f"the answer shows by {seen.fraction:.0%}, which isn't {wanted}"


def _reduce(task: Task, anew: Remeasurement) -> Iterator[str]:
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


def _marked(task: Task, anew: Remeasurement) -> Iterator[str]:
    for mark in task.marks:
        share = anew.seen[mark.instance].fraction
        if not LITTLE[0] <= share <= LITTLE[1] or is_seen(anew.seen[mark.instance]):
            yield f"{mark.letter} shows by {share:.0%}"
        u, v = mark.point
        inside = ndimage.distance_transform_edt(anew.labels == mark.instance)[v, u]
        if inside < INSIDE_PX - 1:
            yield f"mark {mark.letter} is only {inside:.0f} px inside of its thing"


def _compare(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from _marked(task, anew)
    twins = task.certificate.candidates[len(PAIR) :]
    for mark, twin in zip(task.marks, twins, strict=True):
        share = shared(anew.view, anew.scene, anew.labels, mark.instance, twin, anew.library)
        if share < ALIKE - _SAME:
            yield f"{1 - share:.0%} of what shows of {mark.letter} tells it from its twin"
    try:
        lead = anew.worlds(_matter(task, anew), PAIR.index(task.answer))["patch_lead"]
    except Rejected as failure:
        yield failure.rejection.detail
        return
    stated = task.certificate.measures["patch_lead"]
    if abs(lead - stated) > _SAME_COLOUR:
        yield f"the right one's patch leads by {lead:.1f}, not {stated:.1f}"


def _matter(task: Task, anew: Remeasurement) -> CompareQuestion:
    like = task.form == "like"
    a, b = (mark.instance for mark in task.marks)
    return CompareQuestion(
        task.form,
        (a, b),
        (task.certificate.candidates[2], task.certificate.candidates[3]),
        "" if like else task.subject,
        anew.called(task.subject).instance if like else None,
    )


def _size(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from _marked(task, anew)
    larger, smaller = (VisiblePatch.of(anew.labels, mark.instance) for mark in _by_size(task))
    leads = leads_of(larger, smaller)
    if not are_within(leads, [int(math.copysign(1, lead)) for lead in leads]):
        yield f"what shows tells too much: the larger one leads by {leads}"


def _by_size(task: Task) -> Sequence[Mark]:
    """The larger thing's mark, then the other's."""
    return _right_first(task)[::-1] if task.form == "smaller" else _right_first(task)


def _right_first(task: Task) -> Sequence[Mark]:
    return sorted(task.marks, key=lambda mark: mark.letter != task.answer)


_RULES: dict[QuestionType, Callable[[Task, Remeasurement], Iterator[str]]] = {
    "beneath": _beneath,
    "compare": _compare,
    "count": _count,
    "find": _find,
    "reduce": _reduce,
    "size": _size,
}
