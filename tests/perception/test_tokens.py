import pytest

from probe.perception.tokens import MIXED_UP, REMOTE, colour_likeness, colour_match, tokens


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The T-rex", ["rex"]),
        ("a child's toy", ["child", "toy"]),
        ("tea pot, teapots", ["teapot", "teapot"]),
        ("paintbrush", ["paint", "brush"]),
        ("yo-yo", ["yoyo"]),
        ("two knives and glasses", ["two", "knife", "glass"]),
        ("7 potatoes", ["7", "potato"]),
        ("greyish mauve", ["gray", "purple"]),
    ],
)
def test_words_come_in_one_form(text, words):
    assert tokens(text) == words


def test_colours_that_people_mix_up_count_less_and_others_nothing():
    assert colour_likeness("gray", "silver") == colour_match("gray", "silver") == MIXED_UP
    assert colour_likeness("white", "gray") == REMOTE and colour_match("white", "gray") == 0
    assert colour_likeness("red", "green") == 0
