"""By how much what shows of one of two things fits better what Compare asks for."""

from __future__ import annotations

import math

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.errors import UnknownName
from probe.perception.colour_words import KNOWN, colours_in
from probe.tasks.type_rules import Form
from probe.types import Array

LEAD, LEAD_DARKER = 8.0, 16.0
"""Least by which one patch fits better, CIEDE2000 and, for "darker", L*."""

_STRAY = 3.0
"""By how much light may change what was planned."""


def wanted(word: str, model: Array | None) -> Array:
    """The colour that is asked for, CIELAB, shape (3,): that of a thing, else what a word means.

    Args:
        word: The colour's name; without any, nothing depends on the result.
        model: Main colour of the thing that is named, or None.

    Raises:
        UnknownName: Nobody knows what the word means.
    """
    if model is not None:
        return model
    if not word:
        return np.zeros(3)
    meant = colours_in(word)
    if not meant:
        raise UnknownName("colour", word, list(KNOWN))
    return meant[-1]


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
