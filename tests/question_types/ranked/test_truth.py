"""Which thing under like covers has a rank by length, on scenes made by hand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.question_types.ranked.rules import RANKS
from probe.question_types.ranked.truth import has_rank, longest_first
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette
from probe.types import Pose

COVERS = ONE, TWO, THREE = 1, 2, 3
PEN, KEY, DIE = 4, 5, 6
NAMES = {ONE: "bowl", TWO: "bowl", THREE: "bowl", PEN: "pen", KEY: "key", DIE: "die"}
SCENE = Scene(0, "oak", tuple(PlacedObject(n, name, Pose()) for n, name in NAMES.items()))
LENGTHS = {"pen": 0.08, "key": 0.06, "die": 0.04}


def strip(start: int, stop: int, top: float) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, top)


def found(columns: Sequence[int], top: float = 0.04, pen: float = 0.08) -> list[tuple[str, int]]:
    """The three and their covers with the pen, the key and the die at these columns."""
    shapes = {
        **{cover: strip(30 * place, 30 * place + 20, 0.06) for place, cover in enumerate(COVERS)},
        **{n: strip(it, it + 10, top) for n, it in zip((PEN, KEY, DIE), columns, strict=True)},
    }
    lengths = {**LENGTHS, "pen": pen}
    ordered = longest_first(SCENE, COVERS, shapes, lengths)
    return [(placed.object_id, cover) for placed, cover in ordered]


def test_they_are_ordered_by_length_wherever_they_lie():
    assert found((5, 35, 65)) == [("pen", ONE), ("key", TWO), ("die", THREE)]
    assert found((65, 5, 35)) == [("pen", THREE), ("key", ONE), ("die", TWO)]
    assert found((65, 5, 35), pen=0.03) == [("key", ONE), ("die", TWO), ("pen", THREE)]


def test_each_cover_hides_one():
    for columns in [(5, 35, 88), (5, 35, 36)]:
        with pytest.raises(ValueError, match="Exactly one thing"):
            found(columns)
    with pytest.raises(ValueError, match="Exactly one thing"):
        found((5, 35, 65), top=0.07)


def test_lengths_that_are_nearly_the_same_have_no_order():
    with pytest.raises(ValueError, match="equally long"):
        found((5, 35, 65), pen=0.07)


@given(st.permutations([0.04, 0.05, 0.0625]))
def test_of_three_clear_lengths_each_has_one_rank(lengths):
    ranks = [
        [form for form in RANKS if has_rank(form, it, [other for other in lengths if other != it])]
        for it in sorted(lengths, reverse=True)
    ]
    assert ranks == [["longest"], ["second"], ["shortest"]]


@given(st.floats(0.04, 0.0499), st.sampled_from(RANKS))
def test_a_length_that_is_nearly_that_of_another_has_none(length, form):
    assert not has_rank(form, length, [0.04, 0.08])
