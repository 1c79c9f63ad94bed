from __future__ import annotations

from dataclasses import replace

import pytest

from probe.assets.spec import ObjectSpec
from probe.generation.likeness import says_in_part, sides_alike


@pytest.mark.parametrize(
    ("one", "other", "part"),
    [
        ("tea light", "red tea light", True),
        ("white and orange glue stick", "glue stick", True),
        ("white bowl", "white and blue bowl", True),
        ("orange", "orange ball", False),
        ("red tea light", "blue tea light", False),
        ("tea light", "tea light", False),
    ],
)
def test_a_name_may_say_in_part_what_another_says(one, other, part):
    assert says_in_part(one, other) == says_in_part(other, one) == part


def test_sides_are_compared_as_things_stand():
    one = ObjectSpec(
        "ball", "ball", "ball", ("red",), "A ball.", 0.1, 0.5,
        (0.04, 0.02, 0.02), False, "procedural", "Apache-2.0", "test",
    )  # fmt: skip
    assert sides_alike([one, replace(one, size=(one.size[1], one.size[0], one.size[2]))], 0.0)
    assert not sides_alike([one, replace(one, size=(*one.size[:2], 1.2 * one.size[2]))], 0.1)
