import json

import numpy as np
import pytest

from probe.asking import UnusableReply
from probe.assets.annotation.words import Described, describe, parse

GOOD = {
    "name": "Red coffee mug.",
    "category": "mug",
    "colours": ["red", "white"],
    "description": "A red mug with a white inside.",
}
VIEWS = [np.zeros((8, 8, 3), np.uint8)] * 6


def scripted(*replies: str):
    """A model that says these things in turn, and what it was asked."""
    left, asked = list(replies), []

    def ask(images, text: str) -> str:
        asked.append((len(images), text))
        return left.pop(0)

    return ask, asked


@pytest.mark.parametrize(
    "around", ["{}", "Sure!\n```json\n{}\n```", "<think>a mug?</think> {} Hope that helps."]
)
def test_the_object_is_found_whatever_stands_around_it(around):
    found = parse(around.replace("{}", json.dumps(GOOD)))
    assert found == Described(
        name="red coffee mug",
        category="mug",
        colours=("red", "white"),
        description="A red mug with a white inside.",
    )


@pytest.mark.parametrize(
    ("reply", "words"),
    [
        ("It is a mug.", "no JSON"),
        ("", "no JSON"),
        ('{"name": "red mug"', "no JSON"),
        ('{"name": red}', "broken"),
        (json.dumps({**GOOD, "colours": ["crimson"]}), "colours"),
        (json.dumps({**GOOD, "colours": []}), "colours"),
        (json.dumps({**GOOD, "name": "x" * 60}), "name"),
        (json.dumps({**GOOD, "name": "<b>mug</b>"}), "name"),
        (json.dumps({**GOOD, "description": None}), "description"),
    ],
)
def test_what_breaks_the_schema_is_refused_with_the_place(reply, words):
    with pytest.raises(UnusableReply, match=words):
        parse(reply)


def test_a_broken_reply_gets_one_more_chance_and_is_told_why():
    ask, asked = scripted("A mug.", json.dumps(GOOD))
    assert describe(VIEWS, ask).category == "mug"
    assert [count for count, _ in asked] == [6, 6]
    assert "A mug." in asked[1][1] and "no JSON" in asked[1][1]


def test_a_reply_without_end_is_a_broken_one():
    ask, asked = scripted("{" * 100_000, json.dumps(GOOD))
    assert describe(VIEWS, ask).category == "mug"
    assert "no JSON" in asked[1][1] and len(asked[1][1]) < 5000


def test_two_broken_replies_are_enough():
    ask, asked = scripted("A mug.", "Still a mug.", json.dumps(GOOD))
    with pytest.raises(UnusableReply):
        describe(VIEWS, ask)
    assert len(asked) == 2
