"""The list of a mirrored frame is the mirrored list of the frame."""

from __future__ import annotations

import numpy as np
import pytest

from probe.perception.oracle import Oracle
from probe.toolshed.graph import scene_text
from probe.train.dataset.augment.listing import read_listing
from probe.train.dataset.augment.mirrored_list import level, mirrored_list
from tabletops import Block, paint, spec

SPECS = {n: spec(f"red thing {n}", "red") for n in range(1, 13)}


def told(blocks):
    """What perceive_scene tells of a frame, with object_ids by instance."""
    frame = paint(blocks)
    things = Oracle(SPECS).detect(frame)
    assert frame.labels is not None
    ids = [f"object_{frame.labels[it.point_px[1], it.point_px[0]]}" for it in things]
    return scene_text(things, ids, frame)


def flipped(blocks):
    return [
        Block(b.instance, (1023 - b.box[2], b.box[1], 1023 - b.box[0], b.box[3]), b.height)
        for b in blocks
    ]


def heap(seed):
    """Boxes on and beside each other."""
    rng = np.random.default_rng(seed)
    for n in SPECS:
        left, top = rng.integers(20, 800, 2)
        wide, high = rng.integers(40, 200, 2)
        yield Block(n, (int(left), int(top), int(left + wide), int(top + high)), 0.02 + 0.01 * n)


def rows_of_boxes(seed):
    """Boxes side by side, higher than wide with an odd width, so that their points are certain."""
    rng = np.random.default_rng(seed)
    for row in range(3):
        left = int(rng.integers(20, 90))
        for n in range(4 * row + 1, 4 * row + 5):
            wide, high = 2 * int(rng.integers(20, 90)), int(rng.integers(190, 260))
            top = 20 + 330 * row + int(rng.integers(0, 60))
            yield Block(n, (left, top, left + wide, top + high), float(rng.uniform(0.02, 0.08)))
            left += wide + 1 + int(rng.choice([0, 0, 30]))


@pytest.mark.parametrize("seed", range(3))
def test_it_is_that_of_the_mirrored_frame(seed):
    blocks = [*rows_of_boxes(seed)]
    listing = read_listing(told(blocks))
    assert listing is not None and listing.relations
    assert mirrored_list(listing, 1024).text == told(flipped(blocks))


def test_whatever_the_points_rows_boxes_and_contacts_are_those_of_the_mirrored_frame():
    """Of pixels that lie equally deep the tools name the first, which no list tells."""
    for seed in range(2):
        blocks = [*heap(seed)]
        one, other = read_listing(told(blocks)), read_listing(told(flipped(blocks)))
        assert one is not None and other is not None
        found = mirrored_list(one, 1024)
        things = {it.object_id: it for it in other.things}
        for it in found.things:
            assert it.box == things[it.object_id].box
            assert it.point[1] == things[it.object_id].point[1]
        assert _contacts(found) == _contacts(other)


def _contacts(listing):
    ids = [it.object_id for it in listing.things]
    kinds = {(ids[a], kind, ids[b]) for a, kind, b in listing.relations if "_" not in kind}
    return {it for it in kinds if it[1] in ("on", "covering")}


def test_equally_high_things_change_places():
    # Of odd width, so that the middle column is one.
    blocks = [Block(1, (100, 100, 140, 190)), Block(2, (141, 100, 181, 190), 0.02)]
    listing = read_listing(told(blocks))
    assert listing is not None and [it.object_id for it in listing.things] == [
        "object_1", "object_2",
    ]  # fmt: skip
    assert listing.relations == ((0, "left_of", 1), (0, "covering", 1))
    assert len(level(listing.things)) == 1
    found = mirrored_list(listing, 1024)
    assert [it.object_id for it in found.things] == ["object_2", "object_1"]
    assert found.relations == ((0, "left_of", 1), (1, "covering", 0))
    assert found.text == told(flipped(blocks))


def test_ninths_change_sides():
    # The left third is 342 columns wide, and all of its top is full.
    listing = read_listing(told([Block(1, (0, 0, 341, 340)), Block(2, (600, 700, 640, 799))]))
    assert listing is not None
    found = mirrored_list(listing, 1024)
    assert listing.cluttered == ("top left",)
    assert found.cluttered == ("top right",)
    assert "top left" in found.clear and "top right" in listing.clear
    assert list(found.clear) == sorted(
        found.clear,
        key=lambda it: (
            ["top", "middle", "bottom"].index(it.split()[0]),
            ["left", "centre", "right"].index(it.split()[1]),
        ),
    )


def test_other_texts_are_no_lists():
    assert read_listing("Done: object_1 moved.") is None
    assert read_listing(told([Block(1, (100, 100, 140, 190))]) + "\nThis was the last turn") is None
