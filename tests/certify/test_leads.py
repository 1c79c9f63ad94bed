"""What leads are planned for Compare, and how shade moves colours."""

from __future__ import annotations

import math
from dataclasses import replace

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
def test_a_lead_that_tells_and_one_that_misleads_come_from_one_window(form):
    for large in (False, True):
        tells = replace(PLAN, form=form, large_lead=large, cues=(True, True, True))
        misleads = replace(tells, cues=(False, True, True))
        leads = np.arange(-60, 60, 0.5)
        assert [off_plan(tells, lead) for lead in leads] == [
            off_plan(misleads, -lead) for lead in leads
        ]
        within = [lead for lead in leads if off_plan(tells, lead) < math.inf]
        assert min(within) >= 10, "it has to be seen"
        assert max(within) - min(within) <= 18


def test_the_right_one_leads_if_it_fits_better():
    pair = spec("white cup", "white"), spec("black cup", "black")
    light, dark, wanted = np.array([80.0, 0, 0]), np.array([20.0, 0, 0]), np.array([25.0, 0, 0])
    for form in ("darker", "like"):
        fits = [misfit(form, colour, wanted) for colour in (light, dark)]
        assert Asked(pair, 1, "", None).lead(fits) > 0 > Asked(pair, 0, "", None).lead(fits)
