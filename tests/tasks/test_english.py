from __future__ import annotations

import pytest

from probe.tasks.english import listed, plural


@pytest.mark.parametrize(
    ("one", "many"),
    [
        ("red mug", "red mugs"),
        ("matchbox", "matchboxes"),
        ("red and white gum bottle", "red and white gum bottles"),
        ("strawberry", "strawberries"),
        ("yellow toy brick", "yellow toy bricks"),
        ("toy airplane with pilot", "toy airplanes with pilot"),
        ("deck of cards", "decks of cards"),
        ("white die", "white dice"),
        ("red-handled knife", "red-handled knives"),
        ("black computer mouse", "black computer mice"),
        ("tomato", "tomatoes"),
        ("hockey puck", "hockey pucks"),
        ("puzzle cube", "puzzle cubes"),
        ("peach", "peaches"),
        ("battery", "batteries"),
        ("toy", "toys"),
        ("red yo-yo", "red yo-yos"),
        ("wooden paint brush", "wooden paint brushes"),
        ("scissors", None),
        ("black headphones", None),
    ],
)
def test_plural(one, many):
    assert plural(one) == many


def test_names_are_listed_with_their_articles():
    assert listed(["red mug"]) == "the red mug"
    assert listed(["red mug", "die"]) == "the red mug and the die"
    assert listed(["cup", "plate", "die"]) == "the cup, the plate and the die"
