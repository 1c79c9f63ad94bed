from dataclasses import replace

import numpy as np
import pytest

from probe.perception.oracle import NoLabels, Oracle
from probe.types import Frame, Pose
from tabletops import Block, paint, spec

MUG, BOOK, BALL = spec("red mug"), spec("blue book", "blue"), spec("white ball", "white")
WORDS = {3: MUG, 7: BOOK, 12: BALL}


def test_names_only_what_counts_as_seen():
    seen = Block(3, (100, 100, 119, 119), share=0.50)  # 400 px
    partly = Block(7, (300, 100, 399, 199), colour=(30, 60, 150), share=0.29)
    things = Oracle(WORDS).detect(paint([seen, partly]))
    assert [thing.words.name for thing in things] == ["red mug", None]
    assert things[1].words.colours == ("blue",)
    assert "book" not in things[1].words.description


def test_little_of_a_thing_is_told_coarsely_however_large_its_share():
    few = Block(3, (100, 100, 118, 119), share=1.0)  # 380 px
    (thing,) = Oracle(WORDS).detect(paint([few]))
    assert not thing.nameable
    assert thing.words.description == "something small: red, what shows is flat boxy"


def test_says_how_much_of_an_unnamed_thing_is_hidden():
    parts = [Block(3, (100, 100, 119, 199), share=0.2), Block(3, (100, 100, 109, 199), share=0.4)]
    told = [Oracle(WORDS).detect(paint([part]))[0].words.description for part in parts]
    assert told[0].startswith("part of something that is mostly hidden: red")
    assert told[1].startswith("part of something that is half hidden: red")


def test_under_125_px_there_is_nothing():
    assert Oracle(WORDS).detect(paint([Block(3, (10, 10, 133, 10))])) == ()
    (sliver,) = Oracle(WORDS).detect(paint([Block(3, (10, 10, 134, 10))]))
    assert not sliver.nameable


def test_tells_the_colour_that_shows_where_the_catalogues_does_not():
    can = spec("mackerel can", "green", description="A green can.")
    (thing,) = Oracle({3: can}).detect(
        paint([Block(3, (100, 100, 199, 199), colour=(130, 130, 130))])
    )
    assert thing.words.description == "A green can; what shows of it is gray."
    assert thing.words.colours == ("green", "gray")


def test_says_how_a_named_thing_lies():
    pot = replace(spec("clay pot", description="An empty clay pot."), hollow=True)
    over = Pose(wxyz=(0.0, 1.0, 0.0, 0.0))
    frame = paint([Block(3, (100, 100, 199, 199))])
    (told,) = Oracle({3: pot}, lambda: {3: over}).detect(frame)
    assert told.words.description == "A clay pot, upside down."
    (untold,) = Oracle({3: pot}).detect(frame)
    assert untold.words.description == "An empty clay pot."


def test_sorts_by_pixel_and_points_lie_inside():
    blocks = [
        Block(3, (500, 600, 599, 699)),
        Block(7, (700, 20, 999, 60), share=0.9),
        Block(12, (100, 600, 199, 699)),
    ]
    things = Oracle(WORDS).detect(paint(blocks))
    assert [thing.words.name for thing in things] == ["blue book", "white ball", "red mug"]
    for thing in things:
        u, v = thing.point_px
        assert thing.mask[v, u]


def test_instance_numbers_leave_no_trace():
    boxes = [(100, 100, 299, 199), (400, 400, 460, 460)]
    first = [Block(3, boxes[0]), Block(7, boxes[1], share=0.1)]
    second = [Block(7, boxes[0]), Block(3, boxes[1], share=0.1)]
    one = Oracle({3: MUG, 7: BOOK}).detect(paint(first))
    other = Oracle({7: MUG, 3: BOOK}).detect(paint(second))
    for a, b in zip(one, other, strict=True):
        assert (a.words, a.point_px, a.box_px) == (b.words, b.point_px, b.box_px)
        assert (a.mask == b.mask).all()


def test_colours_are_needed_of_what_shows():
    oracle = Oracle(WORDS)
    bare, mug = paint([], rgb=False), paint([Block(3, (100, 100, 299, 199))], rgb=False)
    assert not oracle.needs_rgb(bare) and oracle.needs_rgb(mug)
    assert oracle.detect(bare) == ()
    with pytest.raises(NoLabels, match="colours"):
        oracle.detect(mug)


def test_a_patch_that_stays_is_told_alike_and_needs_no_second_look():
    oracle = Oracle(WORDS)
    patch = Block(3, (100, 100, 299, 199), share=0.2)
    elsewhere = Block(7, (500, 500, 600, 600), colour=(30, 60, 150))
    first, _ = oracle.detect(paint([patch, elsewhere]))
    later = paint([patch, elsewhere], rgb=False)
    assert not oracle.needs_rgb(later)
    assert oracle.detect(later)[0].words == first.words
    assert oracle.needs_rgb(paint([Block(3, (101, 100, 300, 199), share=0.2)], rgb=False))


def test_refuses_frames_of_a_real_camera():
    frame = paint([])
    with pytest.raises(NoLabels, match="segmentation model"):
        Oracle(WORDS).detect(Frame(frame.camera, frame.depth, np.zeros((1024, 1024, 3), np.uint8)))
