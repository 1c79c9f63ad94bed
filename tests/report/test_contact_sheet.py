from __future__ import annotations

from contextlib import contextmanager
from types import SimpleNamespace

import numpy as np
import pytest

from probe.assets.library import Library, open_library
from probe.report.contact_sheet import CAPTION_PX, TILE_PX, contact_sheet, one_a_category

FEW = ("proc_red_mug", "proc_banana", "proc_white_die")


@pytest.fixture(scope="module")
def library(cache) -> Library:
    return open_library("procedural", None, cache)


def test_the_first_of_each_category(library):
    first = one_a_category(library.specs)
    categories = [spec.category for spec in first]
    assert len(set(categories)) == len(categories)
    assert set(categories) == {spec.category for spec in library.specs}
    assert first[0] == library.specs[0]


def test_a_sheet_is_drawn_by_the_chosen_renderer(library, monkeypatch):
    asked = list[str]()

    @contextmanager
    def painter(engine):
        asked.append(engine)
        yield SimpleNamespace(load=lambda *_: None)

    grey = np.zeros((TILE_PX, TILE_PX, 3), np.uint8)
    monkeypatch.setattr("probe.report.contact_sheet.Renderer", painter)
    monkeypatch.setattr("probe.report.contact_sheet.portrait", lambda *_: grey)
    contact_sheet(library, [library[FEW[0]]], named=False, renderer="blender")
    assert asked == ["blender"]


@pytest.mark.slow
def test_a_sheet_shows_each_object_whole_in_a_tile_of_its_own(library):
    specs = [library[object_id] for object_id in FEW]
    sheet = np.asarray(contact_sheet(library, specs, named=False)).astype(int)
    assert sheet.shape == (TILE_PX + CAPTION_PX, 3 * TILE_PX, 3)
    tiles = [sheet[:TILE_PX, k * TILE_PX : (k + 1) * TILE_PX] for k in range(3)]
    means: list[np.ndarray] = []
    for tile in tiles[:2]:  # a white die hardly differs from its ground
        coloured = np.ptp(tile, axis=2) > 40
        means.append(tile[coloured].mean(axis=0))
        rows, columns = (np.flatnonzero(coloured.any(axis=axis)) for axis in (1, 0))
        assert max(np.ptp(rows), np.ptp(columns)) > 0.4 * TILE_PX
        assert min(rows[0], columns[0]) > 0
        assert max(rows[-1], columns[-1]) < TILE_PX - 1
    (red, green, _), (_, other_green, other_blue) = means
    assert red > 1.5 * green
    assert other_green > 1.5 * other_blue
    named = np.asarray(contact_sheet(library, specs[:1], named=True))
    assert (named[TILE_PX:] < 128).sum() > (sheet[TILE_PX:, :TILE_PX] < 128).sum()
