import numpy as np
import pytest

from probe.perception.looks import belies

RED, GRAY, GREEN = (200, 40, 40), (125, 125, 125), (60, 140, 65)


def pixels(*parts):
    return np.array([colour for colour, count in parts for _ in range(count)], np.uint8)


@pytest.mark.parametrize(
    ("shown", "told", "belied"),
    [
        (pixels((GRAY, 100)), ("green", "white"), ()),  # white in shade
        (pixels((GRAY, 100)), ("green",), ("gray",)),
        (pixels((GRAY, 90), (GREEN, 10)), ("green",), ("gray",)),
        (pixels((GRAY, 80), (GREEN, 20)), ("green",), ()),
        (pixels((RED, 100)), ("dark red",), ()),
        (pixels((RED, 100)), ("clear",), ()),
        (pixels(((20, 20, 22), 100)), ("dark green",), ()),
        (pixels(((20, 20, 22), 100)), ("green",), ("black",)),
        (pixels((RED, 50), (GREEN, 50)), ("blue",), ("red", "green")),
    ],
)
def test_colours_are_told_where_none_of_the_catalogues_shows(shown, told, belied):
    assert belies(shown, told) == belied
