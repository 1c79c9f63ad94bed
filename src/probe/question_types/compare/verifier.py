"""How frozen tasks of Compare are checked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

from probe.assets.colour.difference import ciede2000
from probe.assets.library import Library
from probe.generation.necessary import is_answerable_at_sight
from probe.generation.paint_twins import ALIKE
from probe.generation.palettes import main_colour
from probe.generation.result import Rejected
from probe.generation.twin_placement import shared
from probe.generation.twin_worlds import CompareQuestion
from probe.generation.visibility_rules import is_clear
from probe.tasks.task import PAIR, Task
from probe.tasks.truth import DIFFERENT, which_darker, which_like
from probe.verification.pairs import LETTER_AREA, mark_problems, pair_problems, right_first
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import instances_called, spec_of, subject_is
from probe.verification.type_verifier import Crossing, Makeup, Verifier

_SAME = 0.02
"""How far shares may differ on another kind of machine."""

_SAME_COLOUR = 1.0
"""How far colours may, CIEDE2000 or L*: less than an eye sees side by side."""


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    return {"colour": task.subject, "name": task.subject}


def _listed(task: Task, library: Library) -> Iterator[str]:
    """Whether its twins could be twins, and what it compares with is there."""
    for mark, twin in zip(task.marks, task.certificate.candidates[len(PAIR) :], strict=False):
        one, other = library[task.scene[mark.instance].object_id], library[twin]
        if (one.category, one.size, one.mass) != (other.category, other.size, other.mass):
            yield f"{one.id} and {twin} aren't of one shape"
    if task.form == "like":
        called = instances_called(task.subject, task, library)
        if len(called) != 1:
            yield f"{len(called)} things on the table are called {task.subject!r}"


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from pair_problems(task)
    if task.form == "darker":
        yield from subject_is(task, "")
        return
    right, wrong = (spec_of(task, mark.instance, library) for mark in right_first(task))
    wanted = task.subject
    if task.form == "like":
        (third,) = instances_called(task.subject, task, library)
        wanted = spec_of(task, third, library).colours[0]
        if third in task.targets:
            yield "it compares a marked thing with itself"
    if right.colours[0] != wanted or wrong.colours[0] == wanted:
        yield f"of the two marked things, {task.answer} alone should be mainly {wanted}"


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from mark_problems(task, anew)
    matter, lie_open = _matter(task, anew), is_answerable_at_sight(task)
    if matter.reference is not None and not is_clear(seen := anew.seen[matter.reference]):
        yield f"only {seen.fraction:.0%} of the {task.subject} show"
    if not lie_open:
        yield from _telling(task, anew)
    if not all(anew.seen[number].visible_px for number in matter.compared):
        return  # what doesn't show has no colour, as the lines above say
    try:
        right = PAIR.index(task.answer)
        lead = anew.worlds(matter, right, lie_open=lie_open)["patch_lead"]
    except Rejected as failure:
        yield failure.rejection.detail
        return
    stated = task.certificate.measures["patch_lead"]
    if abs(lead - stated) > _SAME_COLOUR:
        yield f"the right one's patch leads by {lead:.1f}, not {stated:.1f}"


def _telling(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What shows of a marked thing that its paint twin doesn't share."""
    twins = task.certificate.candidates[len(PAIR) :]
    for mark, twin in zip(task.marks, twins, strict=True):
        share = shared(anew.view, anew.scene, anew.labels, mark.instance, twin, anew.library)
        if share < ALIKE - _SAME:
            yield f"{1 - share:.0%} of what shows of {mark.letter} tells it from its twin"


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


def _true_text(task: Task, anew: Remeasurement) -> str:
    ids = [task.scene[mark.instance].object_id for mark in task.marks]
    a, b = (main_colour(anew.library, id) for id in ids)
    if task.form == "darker":
        return f"Object {which_darker(a, b)}"
    if task.form == "like":
        reference = anew.called(task.subject).object_id
        return f"Object {which_like(a, b, main_colour(anew.library, reference))}"
    return f"Object {PAIR[[anew.library[id].colours[0] for id in ids].index(task.subject)]}"


def _clear(task: Task, anew: Remeasurement) -> Iterator[str]:
    a, b = (main_colour(anew.library, task.scene[mark.instance].object_id) for mark in task.marks)
    if float(ciede2000(a, b)) < DIFFERENT:
        yield "the two marked things are alike in colour"


def _patches(task: Task) -> str:
    tell = "tell" if task.certificate.measures["patch_lead"] > 0 else "mislead"
    return f"{task.answer}, patches {tell}"


VERIFIER = Verifier(
    makeup=Makeup(len(PAIR), 2 * len(PAIR), ("patch_lead",)),
    slots=_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
    listed=_listed,
    clear=_clear,
    crossed=(
        Crossing(
            "letter x patches",
            [f"{a}, patches {b}" for a, b in product(PAIR, ("tell", "mislead"))],
            _patches,
        ),
        LETTER_AREA,
    ),
)
