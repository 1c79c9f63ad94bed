from __future__ import annotations

import numpy as np
import pytest

from probe.tasks.marks import drawn
from probe.tasks.task import Mark

PICTURE = np.full((1024, 1024, 3), 120, np.uint8)


@pytest.mark.parametrize("point", [(512, 300), (6, 6), (1017, 1017), (6, 1017), (512, 512)])
def test_a_mark_is_a_dot_with_its_letter_beside_it(point) -> None:
    marked = drawn(PICTURE, [Mark("A", 3, point)])
    changed = (marked != PICTURE).any(axis=2)
    u, v = point
    assert tuple(marked[v, u]) == (255, 255, 255)
    rows, columns = np.nonzero(changed)
    assert np.hypot(rows - v, columns - u).max() < 60
    # The dot is small: what it marks stays in view around it. The letter lies apart from it.
    assert 200 < changed.sum() < 1500


def test_without_marks_the_picture_is_as_it_was() -> None:
    assert drawn(PICTURE, []) is PICTURE


def test_the_letters_differ() -> None:
    a, b = (drawn(PICTURE, [Mark(letter, 1, (500, 500))]) for letter in ("A", "B"))
    assert (a != b).any()
