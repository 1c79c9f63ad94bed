"""How frozen tasks of Size are checked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

from probe.assets.library import Library
from probe.generation.size_cues import VisiblePatch, are_within, leads_of
from probe.generation.sizes import extent_of
from probe.tasks.task import PAIR, Mark, Task
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
    larger, smaller = (VisiblePatch.of(anew.labels, mark.instance) for mark in _by_size(task))
    leads = leads_of(larger, smaller)
    if not are_within(leads, [int(math.copysign(1, lead)) for lead in leads]):
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
    ),
)
