"""Counting what shows."""

import numpy as np

from probe.scene.visibility import visibilities


def test_counts_by_hand():
    labels = np.array([[0, 1, 1], [0, 2, 1]])
    alone_1 = np.array([[0, 1, 1], [0, 1, 1]], dtype=bool)
    alone_2 = np.array([[0, 0, 0], [0, 1, 1]], dtype=bool)
    nowhere = np.zeros((2, 3), dtype=bool)
    found = visibilities(labels, {1: alone_1, 2: alone_2, 7: nowhere})
    assert (found[1].visible_px, found[1].alone_px, found[1].fraction) == (3, 4, 0.75)
    assert found[2].fraction == 0.5
    assert found[7].fraction == 0
