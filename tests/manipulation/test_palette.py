from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.manipulation.palette import Palette

RED, BLUE, GREY = (200, 40, 30), (30, 60, 190), (128, 128, 128)


def picture(left: tuple[int, int, int], right: tuple[int, int, int]):
    rgb = np.empty((20, 40, 3), np.uint8)
    rgb[:, :20], rgb[:, 20:] = left, right
    mask = np.zeros((20, 40), bool)
    mask[:, :20] = True
    return rgb, mask


def test_only_pixels_of_the_things_colour_are_likely() -> None:
    rgb, mask = picture(RED, GREY)
    likely = Palette.of(rgb, mask).likely(rgb)
    assert likely[mask].min() > 0.9 and likely[~mask].max() < 0.1


def test_a_colour_that_was_nowhere_is_unlikely() -> None:
    palette = Palette.of(*picture(RED, GREY))
    assert palette.likely(picture(BLUE, BLUE)[0]).max() < 0.1


def test_the_same_colours_are_alike_and_others_are_not() -> None:
    palette = Palette.of(*picture(RED, GREY))
    other, there = picture(BLUE, RED)
    assert palette.alike(other, ~there) == pytest.approx(1.0, abs=1e-6)
    assert palette.alike(other, there) < 0.05


def test_a_half_that_fits_is_half_alike() -> None:
    palette = Palette.of(*picture(RED, GREY))
    both, _ = picture(RED, BLUE)
    # Bhattacharyya's coefficient of one bin with half of the weight.
    assert palette.alike(both, np.ones((20, 40), bool)) == pytest.approx(np.sqrt(0.5), abs=0.01)


@given(st.integers(0, 2**32 - 1))
def test_likelihoods_are_shares_whatever_the_picture(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rgb = rng.integers(0, 256, (8, 8, 3), np.uint8)
    mask = rng.random((8, 8)) < 0.5
    palette = Palette.of(rgb, mask)
    likely = palette.likely(rgb)
    assert ((likely >= 0) & (likely <= 1)).all()
    assert 0 <= palette.alike(rgb, mask) <= 1 + 1e-9
