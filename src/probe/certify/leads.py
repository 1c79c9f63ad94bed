"""By how much what shows of one of two things fits better what Compare asks for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.certify.palettes import dimmed, main_colour
from probe.certify.plan import Plan
from probe.certify.rims import rim_colours
from probe.tasks.task import Form
from probe.types import Array

_LEADS, _LEADS_DARKER = (8.0, 22.0), (16.0, 40.0)
"""Least and most by which one patch fits better, CIEDE2000 and, for "darker", L*: the same whether
it tells or misleads, for natural amounts differ. Each half of it is planned equally often."""

_BESTS = 12.0, 28.0
"""Likewise, how far the better patch is from the colour that is asked for, but for "darker": one
that fits well is the right one's in nature, where all that has the colour's name is right."""

_STRAY = 3.0
"""By how much light may change what was planned."""

_IN_THE_OPEN, _BESIDE_COVERS = 0.95, 0.80
"""Cube roots of the light that textures lose in pictures: medians of 17 things and patches."""

_OFTEN = 0.2
"""Share of pairs of rims that have to tell as planned for two things to be tried."""


@dataclass(frozen=True, eq=False)
class Asked:
    """What is asked about: the two, and what their colour is compared with.

    Attributes:
        marked: A first.
        right: Index of the right one.
        word: The colour's name; empty where none is named.
        reference: The thing in plain view whose colour is asked for, or None.
    """

    marked: tuple[ObjectSpec, ObjectSpec]
    right: int
    word: str
    reference: ObjectSpec | None

    @property
    def model(self) -> ObjectSpec:
        """The thing whose main colour is asked for."""
        return self.reference or self.marked[self.right]

    def lead(self, misfits: Sequence[float]) -> float:
        """By how much a patch of the right thing fits better than one of the wrong one.

        Args:
            misfits: Of a patch of A and of one of B.
        """
        return misfits[1 - self.right] - misfits[self.right]


def misfit(form: Form, patch: Array, wanted: Array) -> float:
    """How far a patch is from what is asked: the lighter, or the less like it, the further."""
    return float(patch[0] if form == "darker" else ciede2000(patch, wanted))


def shaded(form: Form, texture: Array, wanted: Array) -> float:
    """The same, of a patch whose texture is known: covers take some of its light."""
    return misfit(form, dimmed(texture, _BESIDE_COVERS), wanted)


def off_plan(plan: Plan, asked: Asked, misfits: Sequence[float]) -> float:
    """How far patches of A and B are from the middle of what is planned; infinity outside of it."""
    lead = asked.lead(misfits)
    leads = _LEADS_DARKER if plan.form == "darker" else _LEADS
    off = _off(lead if plan.cues[0] else -lead, leads, plan.large_lead)
    return off if plan.form == "darker" else math.hypot(off, _off(min(misfits), _BESTS, plan.far))


def _off(value: float, window: tuple[float, float], upper: bool) -> float:
    """From the middle of the upper or lower half of a window."""
    half = (window[1] - window[0]) / 2
    off = abs(value - window[0] - half * (1.5 if upper else 0.5))
    return off if off <= half / 2 + _STRAY else math.inf


def may_show(form: Form, lead: float, best: float) -> bool:
    """Whether patches could be planned so, to tell or to mislead.

    Args:
        form: Of the question.
        lead: By how much one fits better.
        best: How far that one is from what is asked.
    """
    if form == "darker":
        return _is_near(abs(lead), _LEADS_DARKER)
    return _is_near(abs(lead), _LEADS) and _is_near(best, _BESTS)


def _is_near(value: float, window: tuple[float, float]) -> bool:
    return window[0] - _STRAY <= value <= window[1] + _STRAY


def could_show(library: Library, plan: Plan, asked: Asked) -> bool:
    """Whether rims of both, if these alone showed, would tell as planned, often enough."""
    wanted = in_the_open(main_colour(library, asked.model.id))
    misfits = [
        [shaded(plan.form, np.array(lab), wanted) for lab in rim_colours(library, spec.id)]
        for spec in asked.marked
    ]
    pairs = list(product(*misfits))
    fitting = sum(off_plan(plan, asked, pair) < math.inf for pair in pairs)
    return fitting >= _OFTEN * max(1, len(pairs))


def in_the_open(texture: Array) -> Array:
    """What a picture shows of a colour that nothing shades, CIELAB, shape (3,)."""
    return dimmed(texture, _IN_THE_OPEN)
