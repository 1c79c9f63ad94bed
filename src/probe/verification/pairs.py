"""Checks of tasks about two marked things; shared by the verifiers of Compare and Size."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from scipy import ndimage

from probe.generation.marked import INSIDE_PX
from probe.generation.necessary import is_answerable_at_sight
from probe.generation.visibility_rules import LITTLE, is_clear, is_seen
from probe.tasks.task import PAIR, Mark, Task
from probe.verification.remeasure import Remeasurement
from probe.verification.type_verifier import Crossing


def right_first(task: Task) -> Sequence[Mark]:
    """The right thing's mark, then the other's."""
    return sorted(task.marks, key=lambda mark: mark.letter != task.answer)


def pair_problems(task: Task) -> Iterator[str]:
    """Whether its marks are on its targets, and its certificate is about those."""
    a, b = (mark.instance for mark in task.marks)
    if a == b or task.targets != (a, b):
        yield "its marks aren't on its two targets, A first"
    lie_there = tuple(task.scene[number].object_id for number in (a, b))
    if task.certificate.candidates[: len(PAIR)] != lie_there:
        yield "its certificate is about other things than the marked ones"


def mark_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """Whether a little of each marked thing shows, and the marks lie well inside of that.

    Of tasks that can be answered at sight, whether both are clear.
    """
    for mark in task.marks:
        seen = anew.seen[mark.instance]
        little = LITTLE[0] <= seen.fraction <= LITTLE[1] and not is_seen(seen)
        if not (is_clear(seen) if is_answerable_at_sight(task) else little):
            yield f"{mark.letter} shows by {seen.fraction:.0%}"
        u, v = mark.point
        inside = ndimage.distance_transform_edt(anew.labels == mark.instance)[v, u]
        if inside < INSIDE_PX - 1:
            yield f"mark {mark.letter} is only {inside:.0f} px inside of its thing"


def _area(task: Task) -> str:
    """The letter, and whether more pixels of the right thing show."""
    seen = [task.certificate.visibility[mark.instance] for mark in task.marks]
    right, wrong = seen if task.answer == "A" else seen[::-1]
    return f"{task.answer}, more of it shows: {right.visible_px > wrong.visible_px}"


LETTER_AREA = Crossing(
    "letter x larger area",
    [f"{a}, more of it shows: {b}" for a, b in product(PAIR, (True, False))],
    _area,
)
