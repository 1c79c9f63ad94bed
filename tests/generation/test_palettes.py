"""Which things are mainly of one colour."""

from __future__ import annotations

from typing import Any

import pytest

from probe.generation import palettes
from probe.generation.palettes import ThingColour, has_one_main_colour


@pytest.mark.parametrize(
    ("shares", "has"),
    [((1.0,), True), ((0.6, 0.4), True), ((0.38, 0.34), False), ((0.35, 0.3, 0.3), True)],
)
def test_a_main_colour_leads_clearly(shares, has, monkeypatch: pytest.MonkeyPatch):
    colours = tuple(ThingColour((50.0, 0.0, 0.0), share) for share in shares)
    monkeypatch.setattr(palettes, "palette_of", lambda *_: colours)
    library: Any = None
    assert has_one_main_colour(library, "some_thing") is has
