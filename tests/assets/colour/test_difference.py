from __future__ import annotations

import numpy as np
import pytest
from skimage.color import deltaE_ciede2000

from probe.assets.colour.difference import ciede2000

# Sharma, Wu and Dalal 2005, table 1: pairs 1, 7, 9, 13, 17, 25 and 34.
PUBLISHED = [
    ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
    ((50.0, 0.0, 0.0), (50.0, -1.0, 2.0), 2.3669),
    ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0009), 7.1792),
    ((50.0, -0.001, 2.49), (50.0, 0.0009, -2.49), 4.8045),
    ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
    ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
    ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
]


@pytest.mark.parametrize(("one", "other", "expected"), PUBLISHED)
def test_published_pairs(one, other, expected) -> None:
    assert ciede2000(np.array(one), np.array(other)) == pytest.approx(expected, abs=5e-5)
    assert ciede2000(np.array(other), np.array(one)) == pytest.approx(expected, abs=5e-5)


def test_it_agrees_with_another_implementation() -> None:
    rng = np.random.default_rng(0)
    low, high = [0, -100, -100], [100, 100, 100]
    one, other = rng.uniform(low, high, (5000, 3)), rng.uniform(low, high, (5000, 3))
    assert ciede2000(one, other) == pytest.approx(deltaE_ciede2000(one, other), abs=1e-9)


def test_a_colour_is_like_itself() -> None:
    colours = np.array([[0.0, 0.0, 0.0], [50.0, 20.0, -30.0], [100.0, 0.0, 0.0]])
    assert (ciede2000(colours, colours) == 0).all()
