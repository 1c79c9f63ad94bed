"""What pictures show of lengths and heights."""

from __future__ import annotations

import numpy as np
import pytest

from probe.generation.shown import height_spread, least_step
from probe.tasks.truth import Silhouette


def picture(**boxes: tuple[int, int]) -> np.ndarray:
    """Boxes one above the other, columns and rows by number, n1 and so on."""
    labels = np.zeros((90, 90), dtype=np.int32)
    top = 0
    for name, (wide, high) in boxes.items():
        labels[top : top + high, :wide] = int(name[1:])
        top += high
    return labels


def test_the_longer_side_of_a_box_counts_whichever_it_is():
    labels = picture(n1=(40, 10), n2=(8, 30), n3=(20, 20))
    assert least_step(labels, (1, 2, 3)) == pytest.approx(40 / 30)
    assert least_step(labels, (2, 1, 3)) == pytest.approx(30 / 40)


def test_what_does_not_show_has_no_length():
    assert least_step(picture(n1=(40, 10), n2=(20, 10)), (1, 2, 3)) == 0


def test_covers_are_as_level_as_their_tops():
    mask = np.ones((1, 1), dtype=bool)
    shapes = {n: Silhouette(mask, top) for n, top in enumerate((0.05, 0.07, 0.051))}
    assert height_spread(shapes, (0, 2)) == pytest.approx(0.001)
    assert height_spread(shapes, (0, 1, 2)) == pytest.approx(0.02)
