"""What leads are planned for Compare, and how shade moves colours."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.colours import lab
from probe.certify.leads import Asked, misfit, off_plan
from probe.certify.palettes import dimmed
from probe.certify.plan import plan
from tabletops import spec

PLAN = plan("compare", 0)


def test_half_the_light_by_the_book():
    """Greys: L* is 116 Y^(1/3) - 16."""
    half = dimmed(np.array([[100.0, 0, 0], [76.069, 0, 0]]), 0.5 ** (1 / 3))
    assert half[:, 0] == pytest.approx([76.069, 57.075], abs=0.01)


@given(st.integers(60, 255), st.integers(60, 255), st.integers(60, 255), st.floats(0.4, 1.0))
def test_dimming_is_what_less_light_does_to_a_colour(red, green, blue, light):
    rgb = np.array([[red, green, blue]], dtype=np.uint8)
    linear = ((rgb / 255 + 0.055) / 1.055) ** 2.4 * light  # sRGB's curve; the darkest is left out
    darker = np.round((linear ** (1 / 2.4) * 1.055 - 0.055) * 255).clip(0, 255).astype(np.uint8)
    assert np.abs(lab(darker) - dimmed(lab(rgb), light ** (1 / 3))).max() < 1.5


@pytest.mark.parametrize("form", ["darker", "colour", "like"])
@pytest.mark.parametrize(("large", "far"), list(product((False, True), repeat=2)))
def test_patches_that_tell_and_those_that_mislead_come_from_one_window(form, large, far):
    asked = Asked((spec("cup", "red"), spec("mug", "blue")), 0, "", None)
    tells = replace(PLAN, form=form, large_lead=large, far=far, cues=(True, True, True))
    misleads = replace(tells, cues=(False, True, True))
    pairs = list(product(range(0, 70, 2), repeat=2))
    assert [off_plan(tells, asked, pair) for pair in pairs] == [
        off_plan(misleads, asked, pair[::-1]) for pair in pairs
    ]
    within = [pair for pair in pairs if off_plan(tells, asked, pair) < math.inf]
    leads, bests = [b - a for a, b in within], [min(pair) for pair in within]
    assert min(leads) >= 5, "it has to be seen"
    assert max(leads) - min(leads) <= 18
    if form != "darker":
        assert min(bests) >= 9 and max(bests) - min(bests) <= 14
        assert (min(bests) >= 16) == far


def test_the_right_one_leads_if_it_fits_better():
    pair = spec("white cup", "white"), spec("black cup", "black")
    light, dark, wanted = np.array([80.0, 0, 0]), np.array([20.0, 0, 0]), np.array([25.0, 0, 0])
    for form in ("darker", "like"):
        fits = [misfit(form, colour, wanted) for colour in (light, dark)]
        assert Asked(pair, 1, "", None).lead(fits) > 0 > Asked(pair, 0, "", None).lead(fits)
