"""Which things are mainly of one colour."""

from __future__ import annotations

from typing import Any

import pytest

from probe.assets.library import Library, open_library
from probe.generation import palettes
from probe.generation.palettes import ThingColour, has_one_main_colour, palette_of


@pytest.mark.parametrize(
    ("shares", "has"),
    [((1.0,), True), ((0.6, 0.4), True), ((0.38, 0.34), False), ((0.35, 0.3, 0.3), True)],
)
def test_a_main_colour_leads_clearly(shares, has, monkeypatch: pytest.MonkeyPatch):
    colours = tuple(ThingColour((50.0, 0.0, 0.0), share) for share in shares)
    monkeypatch.setattr(palettes, "palette_of", lambda *_: colours)
    library: Any = None
    assert has_one_main_colour(library, "some_thing") is has


def test_a_palette_is_measured_once_and_then_read(cache, monkeypatch: pytest.MonkeyPatch):
    found = palette_of(open_library("procedural", None, cache), "proc_red_mug")
    assert found[0].share > 0.5 and all(0 < colour.share <= 1 for colour in found)

    def nobody(self: Library, object_id: str, looks: int = 1) -> None:
        raise AssertionError(object_id)

    monkeypatch.setattr(Library, "body", nobody)
    palette_of.cache_clear()
    assert palette_of(open_library("procedural", None, cache), "proc_red_mug") == found
