"""Replies of the tools at a mirrored table."""

from __future__ import annotations

import pytest

from probe.train.dataset.augment.mirrored_reply import (
    mirrored_reply,
    orders_level_things,
    orders_others,
)


@pytest.mark.parametrize(
    ("here", "there"),
    [
        ("point: [0, 7]\nbox: [0, 5, 9, 8]", "point: [1023, 7]\nbox: [1014, 5, 1023, 8]"),
        (
            "Done: the fingers found no way to object_1, so the closed gripper first pushed it "
            "towards the left of the picture. Manipulations left: 3.",
            "Done: the fingers found no way to object_1, so the closed gripper first pushed it "
            "towards the right of the picture. Manipulations left: 3.",
        ),
        (
            "object_2 was not found again: it may have left the picture, or be something else.",
            "object_2 was not found again: it may have left the picture, or be something else.",
        ),
        (
            "Nothing that shows in the picture fits this description. It may be hidden by other "
            "objects or not be there at all. Other words, or a place like (512, 300), may help.",
            "Nothing that shows in the picture fits this description. It may be hidden by other "
            "objects or not be there at all. Other words, or a place like (512, 300), may help.",
        ),
        ('description: "bright upright mug (gray)"', 'description: "bright upright mug (gray)"'),
    ],
)
def test_places_and_sides_change(here, there):
    assert mirrored_reply(here, 1024) == there
    assert mirrored_reply(there, 1024) == here


@pytest.mark.parametrize(
    "text", ["the left glove at [5, 6]", "called 'the thing at (12.5, 30.1)'", "turned clockwise"]
)
def test_what_may_mean_a_side_is_not_guessed_at(text):
    assert mirrored_reply(text, 1024) is None


def test_an_order_that_hangs_on_sides_is_noticed():
    assert orders_level_things("point: [5, 6]\nothers:\n- {point: [9, 6]}")
    assert not orders_level_things("point: [5, 6]\nothers:\n- {point: [5, 9]}")
    alone = (
        "Done: it went; object_3 moved. Also moved: mug by about 3 cm, to [5, 6] (object_9 now)."
    )
    assert not orders_others(f"{alone} Manipulations left: 2.")
    assert orders_others(alone.replace("object_9 now).", "object_9 now); ball by about 1 cm."))
    assert orders_others(f"Failed: it slipped. It is object_8 now. {alone}")
    together = "Also moved, and which is which can't be told: mug from [1, 2] and [3, 4] to [5, 6]."
    assert orders_others(f"Done. {together}")
