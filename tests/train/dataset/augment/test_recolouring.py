"""Other colours in Compare: the same thing is right, by another colour."""

from __future__ import annotations

import re

import numpy as np
import pytest

from packed_teacher import names_in, right_darker
from probe.perception.colour_words import KNOWN
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.recolouring import recoloured
from probe.train.dataset.augment.retelling import changed

COLOUR = re.compile(rf"\b(?:{'|'.join(KNOWN)})\b")


def told(task, record, seed=0):
    return recoloured(task, record, np.random.default_rng(seed), speaker(task, record.run))


def all_told(record):
    return "\n".join([record.question.text, *(step.text for step in record.steps)])


def asked_for_colours(episodes):
    return [it for it in episodes if it[0].question_type == "compare" and it[0].form != "darker"]


def test_each_colour_is_another_one_everywhere_and_the_answer_stays(episodes):
    some = asked_for_colours(episodes)
    assert len(some) > 2
    for task, record in some:
        now, after = told(task, record)
        texts = [all_told(it) for it in (record, after)]
        assert COLOUR.sub("", texts[0]) == COLOUR.sub("", texts[1])
        pairs = {*zip(*(COLOUR.findall(text) for text in texts), strict=True)}
        assert len(dict(pairs)) == len(pairs) == len({new for _, new in pairs})
        assert sum(old != new for old, new in pairs) > len(pairs) / 2
        assert (now.answer, after.answer) == (task.answer, record.answer)
        assert now.question == after.question.text


def test_the_teacher_speaks_of_the_new_colours(episodes):
    for task, record in asked_for_colours(episodes):
        _, after = told(task, record)
        listed = {name for names in names_in(after) for name in names if name}
        last = after.steps[-1].call.words
        named = [name for name in listed if name in last]
        assert named and {*COLOUR.findall(last)} <= {*COLOUR.findall(all_told(after))}


# By eye: each of the first is clearly darker than each of the second, those of a pair aren't.
DARK, LIGHT = ("black", "brown", "purple"), ("white", "yellow", "beige")
ALIKE = ({"red", "blue"}, {"green", "gray"}, {"tan", "pink"}, {"silver", "pink"})


@pytest.fixture(scope="module")
def darker(episodes):
    """Right letter, given letter and both colours that the teacher names, in many colours."""
    task, record = right_darker(episodes)
    found = []
    for seed in range(40):
        now, after = told(task, record, seed)
        ((one, two),) = re.findall(r"(\w+) is A; (\w+) is B\b", after.steps[-1].call.words)
        found.append((now.answer, after.answer and after.answer.choice, one, two))
    return found


def test_the_darker_one_is_clearly_darker_and_may_be_the_other_one(darker):
    assert {right for right, *_ in darker} == {"A", "B"}
    assert all(right == given for right, given, *_ in darker)
    a = [right for right, _, one, two in darker if one in DARK and two in LIGHT]
    b = [right for right, _, one, two in darker if one in LIGHT and two in DARK]
    assert {*a} == {"A"} and {*b} == {"B"} and len(a) + len(b) > 4


def test_colours_of_about_the_same_lightness_are_not_taken(darker):
    assert not [it for it in darker if {*it[2:]} in ALIKE or it[2] == it[3]]


def test_a_thing_with_the_name_of_a_colour_is_refused(episodes):
    task, record = asked_for_colours(episodes)[0]
    name = next(name for names in names_in(record) for name in names if name)
    with pytest.raises(NotCertain, match="a name is a colour"):
        told(*changed(task, record, lambda text: text.replace(name, "orange")))


def test_where_no_colour_is_asked_for_they_stay(episodes):
    task, record = next(it for it in episodes if it[0].question_type == "size")
    with pytest.raises(NotCertain, match="its colours don't matter"):
        told(task, record)
