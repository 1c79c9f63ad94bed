import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.perception.outline import box_of, interior_point, shape_word

SIZE = 200


def disc(u, v, radius):
    rows, columns = np.mgrid[:SIZE, :SIZE]
    return (columns - u) ** 2 + (rows - v) ** 2 <= radius**2


def slanted(long, short, angle):
    rows, columns = np.mgrid[:SIZE, :SIZE] - 100
    along = columns * np.cos(angle) + rows * np.sin(angle)
    across = rows * np.cos(angle) - columns * np.sin(angle)
    return (abs(along) <= long / 2) & (abs(across) <= short / 2)


@given(st.integers(30, 170), st.integers(30, 170), st.integers(5, 25))
def test_the_deepest_point_of_a_disc_is_its_middle(u, v, radius):
    mask = disc(u, v, radius)
    assert interior_point(mask) == (u, v)
    assert box_of(mask) == (u - radius, v - radius, u + radius, v + radius)


def test_the_deepest_point_is_in_the_larger_patch():
    assert interior_point(disc(50, 50, 10) | disc(150, 120, 20)) == (150, 120)


def test_the_border_of_the_picture_is_an_edge():
    mask = np.zeros((SIZE, SIZE), bool)
    mask[:41, :] = True
    u, v = interior_point(mask)
    assert v == 20 and 19 <= u <= 180


@given(st.floats(0, np.pi))
def test_shape_words_do_not_depend_on_the_direction(angle):
    assert shape_word(slanted(120, 20, angle), np.zeros(5)) == "long"
    assert shape_word(slanted(100, 60, angle), np.array([0.0, 0.0, 0.05, 0.05])) == "boxy"
    assert shape_word(slanted(100, 60, angle), np.full(5, 0.02)) == "flat boxy"
    assert shape_word(slanted(40, 38, angle), np.full(5, 0.02)) == "flat boxy"


@pytest.mark.parametrize("radius", [8, 20, 40])
def test_discs_are_round(radius: int):
    assert shape_word(disc(100, 100, radius), np.zeros(5)) == "round"


def test_a_ring_is_irregular_or_long():
    ring = disc(100, 100, 40) & ~disc(120, 100, 35)
    assert shape_word(ring, np.zeros(5)) in ("irregular", "long")


@given(st.binary(min_size=100, max_size=100).filter(any))
def test_any_mask_has_a_point_inside(noise):
    mask = (np.frombuffer(noise, np.uint8) > 128).reshape(10, 10)
    if mask.any():
        u, v = interior_point(mask)
        assert mask[v, u]
