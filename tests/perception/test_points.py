import json
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.asking import UnusableReply
from probe.perception.points import Convention, read_point

CONVENTIONS = st.sampled_from(get_args(Convention))
FORMS = (
    '{{"point": [{a}, {b}]}}',
    '```json\n[{{"point_2d": [{a}, {b}], "label": "mug at (1, 2)"}}]\n```',
    "The mug is at ({a}, {b}).",
    "I first thought of (3, 4), but it is [{a}, {b}]",
    "<point>{a}, {b}</point>",
    '{{"points": [{{"p": [{a}, {b}]}}, {{"p": [7, 7]}}]}}',
)
NAMED = (
    '<point x="{x}" y="{y}" alt="red mug">red mug</point>',
    'Here: {{"x": {x}, "y": {y}}}',
    '<points x1="{x}" y1="{y}" x2="1" y2="1" alt="mugs">mugs</points>',
    "x={x}, y={y}",
)


def written(convention, u, v, width, height):
    """Middle of a pixel in a convention's units: across, down."""
    whole = {"pixels": None, "xy1000": 1000, "yx1000": 1000, "xy100": 100}[convention]
    if whole is None:
        return u, v
    return round((u + 0.5) / width * whole, 6), round((v + 0.5) / height * whole, 6)


@given(CONVENTIONS, st.sampled_from(FORMS), st.integers(0, 1023), st.integers(0, 767))
def test_every_form_gives_the_pixel_it_was_made_of(convention, form, u, v):
    x, y = written(convention, u, v, 1024, 768)
    a, b = (y, x) if convention == "yx1000" else (x, y)
    assert read_point(form.format(a=a, b=b), convention, 1024, 768) == (u, v)


@given(CONVENTIONS, st.sampled_from(NAMED), st.integers(0, 1023), st.integers(0, 767))
def test_names_say_which_is_which(convention, form, u, v):
    x, y = written(convention, u, v, 1024, 768)
    assert read_point(form.format(x=x, y=y), convention, 1024, 768) == (u, v)


def test_a_box_means_its_middle():
    reply = '{"box_2d": [100, 200, 300, 600], "label": "mug"}'
    assert read_point(reply, "yx1000", 1000, 1000) == (400, 200)
    assert read_point(reply, "pixels", 1000, 1000) == (200, 400)


@pytest.mark.parametrize(
    "reply",
    ['{"point": null}', "[]", '{"points": []}', "None of them fits.", "The mug isn't visible."],
)
def test_nothing_found(reply):
    assert read_point(reply, "pixels", 1024, 1024) is None


@pytest.mark.parametrize(
    "reply",
    ["", "A red mug.", "It is 12 cm long.", "{", "[" * 20_000, '{"point": [true, false]}',
     '{"point": ["a", "b"]}', '{"point": [NaN, 3]}', '{"point": [' + "9" * 5000 + ", 1]}",
     '{"point": [1e999, 1]}'],
)  # fmt: skip
def test_no_point_is_an_error(reply):
    with pytest.raises(UnusableReply, match="no point"):
        read_point(reply, "pixels", 1024, 1024)


@pytest.mark.parametrize(
    ("point", "convention"),
    [((1024, 5), "pixels"), ((5, 768), "pixels"), ((-1, 5), "pixels"), ((1001, 5), "xy1000"),
     ((5, -0.5), "yx1000"), ((101, 5), "xy100")],
)  # fmt: skip
def test_a_point_outside_is_refused(point, convention):
    with pytest.raises(UnusableReply, match="outside the picture"):
        read_point(json.dumps({"point": point}), convention, 1024, 768)


def test_the_far_corner_of_a_normalised_picture_is_its_last_pixel():
    assert read_point("[1000, 1000]", "xy1000", 1024, 768) == (1023, 767)


@given(st.text(max_size=200), CONVENTIONS)
def test_whatever_it_says_it_is_a_pixel_or_nothing_or_an_error(reply, convention):
    try:
        point = read_point(reply, convention, 64, 48)
    except UnusableReply:
        return
    assert point is None or (0 <= point[0] < 64 and 0 <= point[1] < 48)
