"""What of the larger thing shows by more: from pictures that can be counted by hand."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest

from probe.generation.size_cues import WINDOWS, SizeCues, VisiblePatch, are_within, leads_of

LABELS = np.zeros((100, 100), int)
LABELS[20:40, 20:60] = 1
LABELS[10:20, :] = 2  # along one long side of it
LABELS[60:70, 20:40] = 3


def test_pixels_diagonal_and_neighbours():
    it = VisiblePatch.of(LABELS, 1)
    assert it.area_px == 20 * 40 and it.diagonal_px == pytest.approx(math.hypot(20, 40))
    # A band of 4 px as wide as a diamond's reach: its part above is about 40 of 120 px round.
    assert it.overlapped == pytest.approx(40 / 120, abs=0.04)
    assert VisiblePatch.of(LABELS, 3).overlapped == 0.0


def test_leads_are_the_larger_ones():
    larger, smaller = VisiblePatch.of(LABELS, 1), VisiblePatch.of(LABELS, 3)
    leads = leads_of(larger, smaller)
    assert leads.area == pytest.approx(math.log(4)) and leads.length == pytest.approx(math.log(2))
    assert leads == tuple(-lead for lead in leads_of(smaller, larger))


def test_windows_are_the_same_on_both_sides():
    inside = SizeCues(*((least + most) / 2 for least, most in WINDOWS))
    for signs in product((1, -1), repeat=3):
        turned = SizeCues(*(sign * lead for sign, lead in zip(signs, inside, strict=True)))
        assert are_within(turned, signs, WINDOWS)
        assert not are_within(turned, [-sign for sign in signs], WINDOWS)
    for place, (least, most) in enumerate(WINDOWS):
        for beyond in (least * 0.9, most * 1.1):
            odd = [*inside]
            odd[place] = beyond
            assert not are_within(SizeCues(*odd), (1, 1, 1), WINDOWS)
