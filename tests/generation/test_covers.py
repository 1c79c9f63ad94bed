from __future__ import annotations

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.covers import (
    Cover,
    Footprint,
    cover_of,
    draw_cover,
    draw_lean,
    draw_shield,
    footprint_of,
)
from probe.types import Pose

MUG, BOOK, CAN, LIME = "proc_red_mug", "proc_blue_paperback", "proc_corn_can", "proc_lime"


def found(library: Library, object_id: str) -> Cover:
    cover = cover_of(library, object_id)
    assert cover is not None
    return cover


def test_a_mug_lies_mouth_down(library: Library):
    mug, size = found(library, MUG), library[MUG].size
    up = Pose(wxyz=mug.wxyz).rotation @ np.array([0, 0, 1])
    assert up[2] == pytest.approx(-1)
    assert mug.extent[2] == pytest.approx(size[2], abs=1e-3)
    # Its cavity is narrower than the mug without its handle, and as deep as most of its height.
    assert 0.5 * min(size[:2]) < mug.width < min(size[:2])
    assert 0.7 * size[2] < mug.depth < size[2]
    # The handle moves the middle of its extent away from that of the mouth.
    assert 0.005 < np.hypot(*mug.middle) < 0.03


def test_a_book_lies_flat_and_holds_nothing(library: Library):
    book = found(library, BOOK)
    assert book.extent[2] == pytest.approx(min(library[BOOK].size), abs=1e-3)
    assert (book.width, book.depth) == (0, 0)


@pytest.mark.parametrize(
    ("object_id", "item", "hides"),
    [
        (MUG, Footprint(0.04, 0.05), True),
        (MUG, Footprint(0.10, 0.05), False),
        (MUG, Footprint(0.04, 0.15), False),
        (BOOK, Footprint(0.06, 0.02), True),
        (BOOK, Footprint(0.06, 0.08), False),  # it would slide off
        (BOOK, Footprint(0.11, 0.02), False),
    ],
)
def test_what_a_cover_hides(library: Library, object_id, item, hides):
    assert found(library, object_id).hides(item) is hides


def test_footprints_are_those_of_the_resting_pose(library: Library):
    can = footprint_of(library, CAN)
    assert can.width == pytest.approx(library[CAN].size[0], rel=0.02)
    assert can.height == library[CAN].size[2]


def test_covers_are_drawn_among_those_that_hide_everything(library: Library):
    room = [footprint_of(library, LIME)]
    names = {
        cover.spec.id
        for seed in range(4)
        if (cover := draw_cover(library, library.specs, room, np.random.default_rng(seed)))
    }
    assert len(names) > 1
    assert all(found(library, name).hides(room[0]) for name in names)
    giant = [Footprint(0.4, 0.3)]
    assert draw_cover(library, library.specs, giant, np.random.default_rng(0)) is None
    assert draw_lean(library, library.specs, giant, np.random.default_rng(0)) is None


def test_what_leans_is_flat(library: Library):
    lean = draw_lean(library, library.specs, [Footprint(0.06, 0.05)], np.random.default_rng(3))
    assert lean is not None and lean.depth == 0


BELT = "proc_black_rolled_belt"


def test_a_rolled_belt_shows_what_lies_beneath_it(library: Library):
    assert not found(library, BELT).closed
    assert found(library, BOOK).closed


def test_a_rolled_belt_shields_only_what_may_show_through(library: Library):
    specs, room, rng = [library[BELT]], [Footprint(0.05, 0.02)], np.random.default_rng(0)
    drawn = draw_shield(library, specs, room, rng)
    assert drawn is not None and drawn.spec.id == BELT
    assert draw_shield(library, specs, room, rng, closed=True) is None
