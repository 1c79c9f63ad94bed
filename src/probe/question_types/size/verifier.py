"""How frozen tasks of Size are checked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

from probe.assets.library import Library
from probe.generation import depth_cues, size_cues
from probe.generation.depth_cues import DepthCues, DepthLook
from probe.generation.necessary import is_answerable_at_sight
from probe.generation.size_cues import SizeCues, VisiblePatch, Windows, are_within
from probe.generation.sizes import extent_of
from probe.tasks.task import DEPTH_RULES, PAIR, Mark, Task
from probe.tasks.truth import which_size
from probe.verification.pairs import LETTER_AREA, mark_problems, pair_problems, right_first
from probe.verification.remeasure import Remeasurement
from probe.verification.subjects import no_slots, spec_of, subject_is
from probe.verification.type_verifier import Crossing, Makeup, Verifier


def _subject(task: Task, library: Library) -> Iterator[str]:
    yield from pair_problems(task)
    yield from subject_is(task, "")
    right, wrong = (max(spec_of(task, mark.instance, library).size) for mark in right_first(task))
    if (right > wrong) == (task.form == "smaller"):
        yield f"by the catalogue's sizes, {task.answer} isn't the {task.form} one"


def _hidden(task: Task, anew: Remeasurement) -> Iterator[str]:
    yield from mark_problems(task, anew)
    if is_answerable_at_sight(task):
        return
    numbers = [mark.instance for mark in _by_size(task)]
    larger, smaller = (VisiblePatch.of(anew.labels, number) for number in numbers)
    yield from _too_much(size_cues.leads_of(larger, smaller), size_cues.WINDOWS)
    if task.version >= DEPTH_RULES:
        high, low = (DepthLook.of(anew.view, task.scene, anew.labels, n) for n in numbers)
        yield from _too_much(depth_cues.leads_of(high, low), depth_cues.WINDOWS)
        if depth_cues.rims_tell(high, low):
            lows = (f"{1000 * look.cover_low:.0f}" for look in (high, low))
            yield f"the covers' lowest points are {' and '.join(lows)} mm above the table"


def _too_much(leads: SizeCues | DepthCues, windows: Windows) -> Iterator[str]:
    if not are_within(leads, [int(math.copysign(1, lead)) for lead in leads], windows):
        yield f"what shows tells too much: the larger one leads by {leads}"


def _by_size(task: Task) -> Sequence[Mark]:
    """The larger thing's mark, then the other's."""
    return right_first(task)[::-1] if task.form == "smaller" else right_first(task)


def _true_text(task: Task, anew: Remeasurement) -> str:
    ids = [task.scene[mark.instance].object_id for mark in task.marks]
    return f"Object {which_size(task.form, *(extent_of(anew.library, id) for id in ids))}"


def _larger(task: Task) -> str:
    """What shows of the larger thing."""
    leads = (task.certificate.measures[name] > 0 for name in ("area_lead", "length_lead"))
    return "more: {}, longer: {}".format(*leads)


def _deep(task: Task) -> str:
    """What depth shows of the larger thing."""
    names = ("cover_height_lead", "height_lead")
    return _DEEP.format(*(task.certificate.measures[name] > 0 for name in names))


_DEEP = "cover higher: {}, thing higher: {}"

VERIFIER = Verifier(
    makeup=Makeup(len(PAIR), len(PAIR), ("area_lead", "length_lead")),
    slots=no_slots,
    subject=_subject,
    hidden=_hidden,
    true_text=_true_text,
    crossed=(
        LETTER_AREA,
        Crossing(
            "what shows of the larger",
            [f"more: {a}, longer: {b}" for a, b in product((True, False), repeat=2)],
            _larger,
        ),
        Crossing(
            "what depth shows of the larger",
            [_DEEP.format(*signs) for signs in product((True, False), repeat=2)],
            _deep,
            since=DEPTH_RULES,
        ),
    ),
)
