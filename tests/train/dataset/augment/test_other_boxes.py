"""Other boxes for two things: they hold what they held, and one is clearly larger."""

from __future__ import annotations

from itertools import islice

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from probe.agents.reading import Seen
from probe.train.dataset.augment.other_boxes import other_factors, resized_box

SIDE_PX = 1024
PLACES = st.integers(0, SIDE_PX - 1)


def seen(name, box, point, object_id="object_1"):
    return Seen(1, name, "", point, box, object_id)


@st.composite
def boxes(draw):
    (left, right), (top, bottom) = (sorted((draw(PLACES), draw(PLACES))) for _ in range(2))
    return left, top, right, bottom


@given(boxes(), st.floats(0.4, 2.5), st.floats(0.4, 2.5))
def test_a_box_stays_in_the_picture_and_has_the_factors_of_its_sides(box, across, down):
    left, top, right, bottom = resized_box(box, (across, down), SIDE_PX)
    assert 0 <= left <= right < SIDE_PX and 0 <= top <= bottom < SIDE_PX
    for factor, old, new in (
        (across, box[2] - box[0], right - left),
        (down, box[3] - box[1], bottom - top),
    ):
        wanted = (old + 1) * factor
        if 41 < wanted < 358:
            assert abs(new + 1 - wanted) <= 0.5


@given(boxes())
def test_a_box_in_the_middle_keeps_its_middle(box):
    left, top, right, bottom = resized_box(box, (1.3, 0.7), SIDE_PX)
    if left > 0 and right < SIDE_PX - 1:
        assert abs((left + right) - (box[0] + box[2])) <= 1
    if top > 0 and bottom < SIDE_PX - 1:
        assert abs((top + bottom) - (box[1] + box[3])) <= 1


def test_each_of_the_two_is_the_larger_one_now_and_then_and_none_loses_what_it_held():
    mark, other_mark = (330, 340), (700, 705)
    part = seen(None, (300, 310, 350, 360), (330, 340))
    one = seen("red cup", (290, 300, 420, 400), (350, 350))
    two = seen("blue cup", (650, 660, 760, 750), (700, 700), "object_2")
    larger = set[str]()
    for seed in range(12):
        rng = np.random.default_rng(seed)
        drawn = other_factors(
            ("red cup", "blue cup"), [part, one, two], [mark, other_mark], SIDE_PX, rng
        )
        for factors in islice(drawn, 3):
            red = resized_box(one.box, factors["red cup"], SIDE_PX)
            blue = resized_box(two.box, factors["blue cup"], SIDE_PX)
            assert red[0] <= 300 and red[1] <= 310 and red[2] >= 350 and red[3] >= 360
            assert blue[0] <= 700 <= blue[2] and blue[1] <= 700 and blue[3] >= 705
            sizes = sorted((box[2] - box[0] + 1) * (box[3] - box[1] + 1) for box in (red, blue))
            assert sizes[1] > 1.2 * sizes[0]
            larger.add(
                "red"
                if red[2] - red[0] > blue[2] - blue[0] and red[3] - red[1] > blue[3] - blue[1]
                else "other"
            )
    assert larger == {"red", "other"}


def test_where_nothing_fits_there_is_none():
    part = seen(None, (0, 0, 1023, 1023), (5, 5))
    one = seen("red cup", (0, 0, 1023, 1023), (5, 5))
    two = seen("blue cup", (650, 660, 760, 750), (700, 700), "object_2")
    drawn = other_factors(
        ("red cup", "blue cup"), [part, one, two], [], SIDE_PX, np.random.default_rng(0)
    )
    assert not list(drawn)
