import pytest

from probe.perception.phrase import head, surroundings
from probe.perception.tokens import tokens


@pytest.mark.parametrize(
    ("text", "noun"),
    [
        ("red mug with a white handle", "mug"),
        ("mugs, blue", "mug"),
        ("half hidden red box", "box"),
        ("the box that lies on a book", "box"),
        ("an ear of corn", "corn"),
        ("box of matches", "box"),
        ("the red thing under the bowl", "red"),
        ("top left mug", "mug"),
        ("the top one", None),
        ("the left one", None),
        ("", None),
    ],
)
def test_the_noun_of_a_description(text, noun):
    assert head(text, {"top"}) == noun


def test_a_spatial_word_that_comes_last_may_be_a_noun():
    assert head("wooden spinning top", {"top"}) == "top"
    assert head("mug at the top", {"top"}) == "mug"


def test_what_is_around_a_thing_is_told_apart_from_what_it_has():
    assert tokens(surroundings("a mug with a spoon next to the plate")) == ["plate"]
