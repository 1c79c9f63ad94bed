import numpy as np
import pytest

from probe.assets.colour.names import lab, main_colours

# Published values: the corners of the sRGB cube in CIELAB under D65 (Lindbloom's calculator).
CORNERS = {
    (255, 255, 255): (100.0, 0.0, 0.0),
    (0, 0, 0): (0.0, 0.0, 0.0),
    (255, 0, 0): (53.24, 80.09, 67.20),
    (0, 255, 0): (87.73, -86.18, 83.18),
    (0, 0, 255): (32.30, 79.19, -107.86),
}


@pytest.mark.parametrize(("rgb", "expected"), CORNERS.items())
def test_lab_of_the_corners(rgb, expected):
    assert np.allclose(lab(np.array([rgb], np.uint8))[0], expected, atol=0.05)


@pytest.mark.parametrize(
    ("rgb", "name"),
    [
        ((200, 30, 30), "red"),
        ((20, 60, 160), "blue"),
        ((240, 240, 240), "white"),
        ((15, 15, 15), "black"),
        ((120, 122, 121), "gray"),
        ((40, 120, 50), "green"),
        ((250, 210, 50), "yellow"),
        ((100, 62, 35), "brown"),
        ((240, 130, 30), "orange"),
    ],
)
def test_plain_patches(rgb, name):
    assert main_colours(np.full((500, 3), rgb, np.uint8)) == (name,)


def test_a_second_colour_counts_from_a_third_or_so():
    red, white = np.full((600, 3), (190, 30, 30)), np.full((400, 3), (240, 240, 240))
    assert main_colours(np.concatenate([red, white]).astype(np.uint8)) == ("red", "white")
    assert main_colours(np.concatenate([red, white[:100]]).astype(np.uint8)) == ("red",)
