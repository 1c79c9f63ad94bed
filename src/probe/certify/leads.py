"""By how much what shows of one of two things fits better what Compare asks for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.spec import ObjectSpec
from probe.certify.colour_words import colours_in
from probe.certify.palettes import dimmed
from probe.tasks.task import Form
from probe.types import Array

LEAD, LEAD_DARKER = 8.0, 16.0
"""Least by which one patch fits better, CIEDE2000 and, for "darker", L*."""

PLAUSIBLE = 28.0
"""Farthest that the better patch is from the colour that is asked for, CIEDE2000."""

_STRAY = 3.0
"""By how much light may change what was planned."""

_IN_THE_OPEN = 0.95
"""Cube root of the light that textures keep in pictures: median of 17 things."""


@dataclass(frozen=True, eq=False)
class Asked:
    """What is asked about: the two, and what their colour is compared with.

    Attributes:
        marked: A first.
        right: Index of the right one.
        word: The colour's name; empty where none is named.
        reference: The thing in plain view whose colour is asked for, or None.
        patches: What is to show of A and of B, CIELAB, shape (3,) each.
        facing: Angles of the sides of A and of B that show it, radians.
    """

    marked: tuple[ObjectSpec, ObjectSpec]
    right: int
    word: str
    reference: ObjectSpec | None
    patches: tuple[Array, Array]
    facing: tuple[Array, Array]

    def lead(self, misfits: Sequence[float]) -> float:
        """By how much a patch of the right thing fits better than one of the wrong one.

        Args:
            misfits: Of a patch of A and of one of B.
        """
        return misfits[1 - self.right] - misfits[self.right]

    def off(self, patches: Sequence[Array]) -> float:
        """How far the patches of A and B are from what is to show, CIEDE2000: the farther one."""
        return max(float(ciede2000(*pair)) for pair in zip(self.patches, patches, strict=True))


def wanted(word: str, model: Array | None) -> Array:
    """The colour that is asked for, CIELAB, shape (3,): that of a thing, else what a word means.

    Args:
        word: The colour's name; without any, nothing depends on the result.
        model: Main colour in a picture of the thing that is named, or None.
    """
    if model is not None:
        return model
    return colours_in(word)[-1] if word else np.zeros(3)


def misfit(form: Form, patch: Array, wanted: Array) -> Array:
    """How far patches are from what is asked: the lighter, or the less like it, the further.

    Args:
        form: Of the question.
        patch: CIELAB, shape (..., 3).
        wanted: CIELAB, shape (3,).

    Returns:
        Shape (...).
    """
    return patch[..., 0] if form == "darker" else ciede2000(patch, wanted)


def least_lead(form: Form) -> float:
    """By how much the better patch has to fit better."""
    return LEAD_DARKER if form == "darker" else LEAD


def leads_enough(form: Form, lead: float) -> bool:
    """Whether a lead could be seen, be it the right thing's or the other's (negative)."""
    return math.fabs(lead) >= least_lead(form) - _STRAY


def in_the_open(texture: Array) -> Array:
    """What a picture shows of a colour that nothing shades, CIELAB, shape (3,)."""
    return dimmed(texture, _IN_THE_OPEN)
