import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.perception.matching import match
from probe.perception.oracle import Oracle
from tabletops import Block, paint, spec

SPECS = [
    spec("red mug", "red", description="A red mug with a handle."),
    spec("blue mug", "blue"),
    spec("figure with red cap", "red", "blue", category="toy figure"),
    spec("golf ball", "white"),
    spec("crayon box", "yellow", "green", description="A small cardboard box with crayons."),
    spec("turquoise plate", "teal", "white"),
    spec("tin of fish", "silver", category="tin"),
]
BLOCKS = [
    Block(n, (100 + 120 * n, 300 + 20 * n, 180 + 120 * n, 380 + 20 * n))
    for n in range(len(SPECS))
    if n
] + [Block(20, (60, 60, 140, 140)), Block(21, (800, 700, 960, 900), share=0.1)]
THINGS = Oracle(dict(enumerate(SPECS)) | {20: SPECS[0], 21: spec("teapot", "green")}).detect(
    paint(BLOCKS)
)


def found(words):
    result = match(words, THINGS)
    return result and result.thing.words.name


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("red mug", "red mug"),
        ("the red mug", "red mug"),
        ("A mug that is red", "red mug"),
        ("Mugs, blue", "blue mug"),
        ("coffee mug, red", "red mug"),
        ("toy figure", "figure with red cap"),
        ("the figure with the red cap", "figure with red cap"),
        ("golf ball", "golf ball"),
        ("box of crayons", "crayon box"),
        ("teal plate", "turquoise plate"),
        ("gray tin", "tin of fish"),
        ("the thing at (60, 60)", "red mug"),
        ("(150.5, 100)", "red mug"),
        ("whatever is at 100, 100", "red mug"),
    ],
)
def test_finds_what_is_meant(words, name):
    assert found(words) == name


@pytest.mark.parametrize(
    "words",
    ["green mug", "teapot", "hammer", "(10, 1000)", "", "the", "object", "🫖", "(9999, 9999)"],
)
def test_finds_nothing_for_what_does_not_show(words):
    assert match(words, THINGS) is None


def test_coarse_things_are_found_by_colour_alone_or_by_place():
    result = match("something red at (880, 800)", THINGS)
    assert result and not result.thing.nameable


def test_spatial_words_choose_among_equals():
    left, right = match("leftmost mug", THINGS), match("mug on the right", THINGS)
    assert left and left.thing.words.name == "red mug"
    assert right and right.thing.words.name == "blue mug"
    either = match("mug", THINGS)
    assert either and [other.words.name for other in either.others] == ["blue mug"]
    assert left.others == ()


def test_spatial_words_alone_choose_among_all():
    largest, top = match("the largest object", THINGS), match("topmost thing", THINGS)
    assert largest and largest.thing.point_px == (880, 780)
    assert top and top.thing.point_px == (100, 100)


@given(st.text(max_size=300))
def test_any_text_is_answered(words):
    match(words, THINGS)
