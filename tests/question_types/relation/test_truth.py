"""What lies under the next cover of a ring, on scenes made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from probe.question_types.relation.truth import clockwise, next_beneath
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette
from probe.types import Pose

COVERS = TOP, RIGHT, LEFT = 1, 2, 3
PEN, KEY, DIE = 4, 5, 6
NAMES = {TOP: "bowl", RIGHT: "bowl", LEFT: "bowl", PEN: "pen", KEY: "key", DIE: "die"}
SCENE = Scene(0, "oak", tuple(PlacedObject(n, name, Pose()) for n, name in NAMES.items()))
AT = {TOP: (50, 15), RIGHT: (80, 70), LEFT: (20, 70)}
"""Middles of the covers in the picture, (u, v): v grows downwards."""


def square(middle: tuple[int, int], half: int, top: float) -> Silhouette:
    u, v = middle
    mask = np.zeros((100, 100), dtype=bool)
    mask[max(v - half, 0) : v + half, max(u - half, 0) : u + half] = True
    return Silhouette(mask, top)


def found(form: str, start: int, top: float = 0.04, die: int = LEFT) -> tuple[str, int]:
    """The answer with the pen under the top bowl, the key under the right and the die elsewhere."""
    shapes = {cover: square(AT[cover], 12, 0.06) for cover in COVERS}
    places = {PEN: TOP, KEY: RIGHT, DIE: die}
    shapes |= {item: square(AT[cover], 4, top) for item, cover in places.items()}
    placed, cover = next_beneath(SCENE, form, start, COVERS, shapes)
    return placed.object_id, cover


@pytest.mark.parametrize(
    ("start", "after", "before"),
    [
        (PEN, ("key", RIGHT), ("die", LEFT)),
        (KEY, ("die", LEFT), ("pen", TOP)),
        (DIE, ("pen", TOP), ("key", RIGHT)),
    ],
)
def test_clockwise_is_as_the_hand_of_a_clock_goes_in_the_picture(start, after, before):
    assert found("clockwise", start) == after
    assert found("anticlockwise", start) == before


def test_each_cover_hides_one_and_the_named_thing_is_one_of_them():
    with pytest.raises(ValueError, match="Exactly one thing"):
        found("clockwise", PEN, top=0.07)
    with pytest.raises(ValueError, match="Exactly one thing"):
        found("clockwise", PEN, die=RIGHT)
    with pytest.raises(ValueError, match="none of the covers"):
        found("clockwise", 7)


def test_the_order_does_not_depend_on_numbers_but_on_places():
    assert clockwise({7: (50, 15), 5: (20, 70), 9: (80, 70)}) in [(7, 9, 5), (9, 5, 7), (5, 7, 9)]


def test_covers_in_a_row_have_no_clear_order():
    with pytest.raises(ValueError, match="ring"):
        clockwise({1: (10, 50), 2: (50, 52), 3: (90, 50)})
