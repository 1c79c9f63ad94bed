from dataclasses import replace

import numpy as np
import pytest

from probe.perception.enrolled.showing import NotAlone, lone_thing, shown
from probe.scene.setup import UR5_TABLE
from tabletops import Block, paint

PIXEL = UR5_TABLE.view_size / 1024
BOX = Block(1, (300, 300, 499, 399), height=0.04)


def test_the_only_thing_is_found_whole_and_measured():
    frame = paint([BOX])
    assert np.array_equal(lone_thing(frame), frame.labels == 1)
    (signature,) = shown([replace(frame, labels=None, shares=None)])
    assert signature.length == pytest.approx(200 * PIXEL, rel=0.12)
    assert signature.width == pytest.approx(100 * PIXEL, rel=0.12)
    assert signature.area == pytest.approx(200 * 100 * PIXEL**2, rel=0.15)
    assert signature.outline == "flat boxy"
    assert signature.colours.sum() == pytest.approx(1)


@pytest.mark.parametrize(
    ("blocks", "words"),
    [
        ([], "nothing on the table"),
        ([BOX, Block(2, (700, 700, 800, 800))], "more than one thing"),
        ([Block(1, (0, 300, 100, 400))], "cuts off"),
    ],
)
def test_anything_else_is_refused_with_a_remedy(blocks, words):
    with pytest.raises(NotAlone, match=words):
        lone_thing(paint(blocks))


def test_places_without_a_reading_are_left_out():
    frame = paint([BOX])
    depth = frame.depth.copy()
    depth[320:330, 320:330] = 0
    depth[800:900, 800:900] = np.nan
    mask = lone_thing(replace(frame, depth=depth))
    assert not mask[320:330, 320:330].any()
    assert mask.sum() == 200 * 100 - 100
