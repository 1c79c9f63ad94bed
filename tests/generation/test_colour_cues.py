"""What leads count in Compare, and how shade moves colours."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.colour.names import lab
from probe.errors import UnknownName
from probe.generation.colour_cues import leads_enough, misfit, wanted
from probe.generation.palettes import dimmed

LIGHT, DARK = np.array([80.0, 0, 0]), np.array([20.0, 0, 0])


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


def test_the_darker_and_the_more_alike_fit_better():
    for form in ("darker", "like"):
        light, dark = (misfit(form, colour, np.array([25.0, 0, 0])) for colour in (LIGHT, DARK))
        assert dark < light


def test_a_thing_in_view_says_what_is_asked_else_the_word_does():
    assert wanted("red", np.array([25.0, 0, 0])) == pytest.approx([25, 0, 0])
    lightness, a, b = wanted("red", None)
    assert lightness < 50 and a > 40 and b > 10
    assert wanted("", None).shape == (3,)


@pytest.mark.parametrize(("form", "least"), [("darker", 13), ("colour", 5), ("like", 5)])
def test_who_leads_by_little_does_not_lead(form, least):
    for sign in (1, -1):
        assert leads_enough(form, sign * (least + 0.1))
        assert not leads_enough(form, sign * (least - 0.1))


def test_a_word_without_a_meaning_is_named():
    with pytest.raises(UnknownName, match="no colour called 'magenta'.*beige"):
        wanted("magenta", None)
