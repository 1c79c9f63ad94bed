import numpy as np
import pytest

from probe.perception.naming import identifies, width_shown

CUP, PEN = (0.08, 0.08, 0.09), (0.14, 0.01, 0.01)


def disc(radius, cut=None):
    """A disc of that radius in pixels, or what a second one of the same size leaves of it."""
    rows, columns = np.mgrid[:300, :300]
    mask = np.hypot(rows - 150, columns - 150) <= radius
    if cut is not None:
        mask &= np.hypot(rows - 150, columns - 150 - cut) > radius
    return mask


def test_half_of_a_thing_names_it_whatever_its_width():
    mask = disc(70, cut=56)
    assert mask.sum() / disc(70).sum() == pytest.approx(0.5, abs=0.02)
    assert identifies(mask, 0.5, CUP)


def test_a_sliver_along_the_edge_does_not():
    mask = disc(70, cut=42)
    share = mask.sum() / disc(70).sum()
    assert 0.3 < share < 0.5
    assert width_shown(mask, share, CUP) < 0.4 and not identifies(mask, share, CUP)


def test_a_piece_as_wide_as_the_whole_does():
    mask = np.zeros((300, 300), bool)
    mask[100:112, 20:100] = True
    assert width_shown(mask, 0.4, PEN) > 0.6 and identifies(mask, 0.4, PEN)
    assert not identifies(mask, 0.29, PEN)


def test_a_whole_disc_is_as_wide_as_itself():
    assert width_shown(disc(70), 1.0, (0.1, 0.1, 0.01)) == pytest.approx(1, abs=0.02)


def test_few_pixels_never_name():
    mask = np.zeros((300, 300), bool)
    mask[:20, :19] = True
    assert not identifies(mask, 1.0, CUP)
    mask[:20, :20] = True
    assert identifies(mask, 1.0, CUP)
