"""Covers are aimed by what is wrong with what shows."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from probe.generation import aimed_nests
from probe.generation.aimed_nests import draw_aimed
from probe.generation.marked import CoveredThing, LyingOut
from probe.generation.result import Rejected
from probe.scene.seeds import generator
from probe.scene.visibility import Visibility

ALONE_PX = 4000
REACH = 0.2

SIDES = np.array([0.0]), np.array([0.0])

MADE: Any = SimpleNamespace(stage=SimpleNamespace(jammed=False))
"""A set that has no more than is looked at here."""


def nest(pixels: float) -> CoveredThing:
    scene: Any = None
    return CoveredThing({}, Visibility(round(pixels), ALONE_PX), np.zeros((1, 1)), scene)


@pytest.fixture
def table(monkeypatch: pytest.MonkeyPatch):
    """A table on which a thing shows the more the further out it is, and nothing slides."""
    monkeypatch.setattr(aimed_nests, "draw_way_out", lambda *_: LyingOut(np.zeros(2), 0.0))
    monkeypatch.setattr(aimed_nests, "furthest_out", lambda *_: REACH)
    monkeypatch.setattr(aimed_nests, "at_rest", lambda made, place, it: it)

    def moved_out(made: object, place: int, way: LyingOut, distance: float) -> CoveredThing:
        return nest(ALONE_PX * distance / REACH)

    monkeypatch.setattr(aimed_nests, "moved_out", moved_out)


def within(windows: tuple[tuple[float, float], tuple[float, float]]):
    """Judges shares: as many as lie in A's and in B's window will do."""

    def fit(place: int, it: CoveredThing) -> int:
        low, high = windows[place]
        return -1 if it.seen.fraction < low else int(it.seen.fraction > high)

    return fit


@pytest.mark.parametrize("more_of_a", [True, False])
def test_a_narrow_window_is_found_wherever_it_is(table: None, more_of_a: bool):
    less, more = (0.05, 0.07), (0.11, 0.13)
    windows = (more, less) if more_of_a else (less, more)
    fit = within(windows)
    a, b = draw_aimed(MADE, fit, SIDES, more_of_a, generator(0, "aim"))
    assert fit(0, a) == fit(1, b) == 0
    assert (a.seen.visible_px > b.seen.visible_px) == more_of_a


@pytest.mark.parametrize("more_of_a", [True, False])
def test_of_one_more_shows_though_both_may_show_alike(table: None, more_of_a: bool):
    window = 0.05, 0.25
    a, b = draw_aimed(MADE, within((window, window)), SIDES, more_of_a, generator(0, "aim"))
    more, less = (a, b) if more_of_a else (b, a)
    assert more.seen.visible_px > 1.1 * less.seen.visible_px


def test_what_can_only_show_the_other_way_round_is_refused(table: None):
    windows = (0.05, 0.07), (0.11, 0.13)
    with pytest.raises(Rejected, match="nothing that was tried"):
        draw_aimed(MADE, within(windows), SIDES, True, generator(0, "aim"))


def test_what_is_jammed_is_not_taken(table: None, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(MADE.stage, "jammed", True)
    window = 0.05, 0.25
    with pytest.raises(Rejected, match="nothing that was tried"):
        draw_aimed(MADE, within((window, window)), SIDES, True, generator(0, "aim"))


def test_what_slides_off_is_not_taken(table: None, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(aimed_nests, "at_rest", lambda *_: None)
    window = 0.05, 0.25
    with pytest.raises(Rejected, match="nothing that was tried"):
        draw_aimed(MADE, within((window, window)), SIDES, True, generator(0, "aim"))
