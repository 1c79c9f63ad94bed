"""What the scripted teacher says of sides."""

from __future__ import annotations

import re

import numpy as np
import pytest

from probe.agents.phrases import PhraseBook, phrases
from probe.train.dataset.augment.teacher_words import are_the_teachers, mirrored_words

SLOTS = {
    "thing": "tall red mug", "id": "object_4", "place": "(5, 6)", "text": "mug",
    "other": "box of tea", "letter": "B", "number": "3", "one": "lime",
    "two": "lemon", "direction": "left", "each": "object_1", "size_one": "[20, 30]",
    "size_two": "[40, 10]", "colour": "green", "colour_one": "green", "colour_two": "yellow",
    "long_one": "30", "long_two": "40", "greater": "larger", "lesser": "smaller",
    "letter_more": "B", "letter_less": "A",
}  # fmt: skip


def test_a_push_is_told_the_other_way_and_all_else_as_it_was():
    told = "That is the right place. I slide the red mug left."
    assert mirrored_words(told, "left") == "That is the right place. I slide the red mug right."
    grasp = "That is the right place. I lift the red mug into the basket."
    assert mirrored_words(grasp) == grasp
    up = "That is the right place. I slide the red mug up."
    assert mirrored_words(up, "up") == up
    assert mirrored_words("") == ""


@pytest.mark.parametrize(
    ("words", "direction"),
    [
        ("I see the mug on the left.", None),
        ("That is the right place. I slide the red mug left.", "right"),
        ("That is the right place. I slide the red mug left.", None),
        ("Found. I remove the left glove.", None),
        ("Found. I remove the mug at (512, 300).", None),
    ],
)
def test_other_words_for_sides_are_not_guessed_at(words, direction):
    assert mirrored_words(words, direction) is None


def test_all_that_the_teacher_says_is_known():
    say = PhraseBook(np.random.default_rng(0))
    for occasion in phrases():
        for _ in range(3):
            said = say(occasion, SLOTS)
            assert are_the_teachers(said)
            assert mirrored_words(said, "left") is not None
    by_id = say("hollow", {**SLOTS, "thing": "object_4"}).replace("the object_4", "object_4")
    assert are_the_teachers(by_id.replace("The object_4", "object_4"))
    both = f"{say('hollow', SLOTS)} {say('grasp', SLOTS)}"
    assert are_the_teachers(both) and mirrored_words(both) == both
    assert not are_the_teachers("The question asks how many mugs there were.")


def test_no_phrase_speaks_of_a_side_but_by_a_direction():
    """Whoever adds a phrase with one of these words has to see that it means no side."""
    known = {
        "nothing is left", "thing that is left", "the right place", "Right against it",
    }  # fmt: skip
    for some in phrases().values():
        for text in some:
            for phrase in known:
                text = text.replace(phrase, "")
            assert not re.search(r"\b(left|right|clockwise)", text, re.IGNORECASE), text
