from __future__ import annotations

import numpy as np
import pytest

from probe.agents.moves import Way
from probe.agents.scripted import Scripted
from tabletops import Block, Obedient, spec

SPECS = {
    1: spec("blue bowl", "blue"),
    2: spec("red die", "red"),
    3: spec("yellow duck", "yellow"),
    4: spec("green book", "green"),
    5: spec("red cup", "red"),
}
PAIR = ["Object A", "Object B"]
TEXT = "Which? In the first picture, the marks are A at (330, 250) and B at (720, 700)."

# Each shows by a strip beside what lies on it: the smaller one by the wider strip.
LONG = Block(2, (200, 200, 349, 299), 0.02)
SHORT = Block(3, (640, 660, 739, 739), 0.02, (200, 180, 40))
OVER_LONG = Block(1, (150, 150, 319, 349), 0.08, (30, 60, 150))
OVER_SHORT = Block(4, (560, 620, 689, 779), 0.08, (40, 120, 50))
TABLE = [LONG, SHORT, OVER_LONG, OVER_SHORT]


def scripted(question_type, form, subject="", first: Way = "grasp"):
    return Scripted(question_type, subject, np.random.default_rng(5), first, form=form)


@pytest.mark.parametrize(("form", "letter"), [("longer", "A"), ("larger", "A"), ("smaller", "B")])
def test_size_goes_by_what_is_uncovered(play, form, letter):
    skills = Obedient()
    record = play(scripted("size", form), PAIR, SPECS, TABLE, skills, TEXT)
    assert record.answer and record.answer.choice == letter
    assert len(skills.calls) == 2


@pytest.mark.parametrize(
    ("form", "subject", "letter"),
    [
        ("colour", "red", "A"),
        ("colour", "yellow", "B"),
        ("darker", "", "A"),
        ("like", "red cup", "A"),
    ],
)
def test_compare_goes_by_the_colours_that_are_named_first(play, form, subject, letter):
    table = [*TABLE, Block(5, (850, 100, 949, 199), 0.05)]
    record = play(scripted("compare", form, subject), PAIR, SPECS, table, text=TEXT)
    assert record.answer and record.answer.choice == letter


def test_without_a_colour_that_tells_nothing_is_answered(play):
    agent = scripted("compare", "colour", "green")
    record = play(agent, PAIR, SPECS, TABLE, text=TEXT)
    assert record.end == "stopped" and record.answer is None


def test_what_cannot_be_uncovered_is_not_judged(play):
    skills = Obedient("blocked")
    record = play(scripted("size", "longer"), PAIR, SPECS, TABLE, skills, TEXT)
    assert record.end == "stopped" and 2 <= record.manipulations <= 10


def test_a_cover_that_was_pushed_onto_the_mark_is_not_taken_for_the_marked_thing(play):
    skills = Obedient()
    record = play(scripted("size", "longer", first="push"), PAIR, SPECS, TABLE, skills, TEXT)
    assert record.answer and record.answer.choice == "A"
    assert [call[0] for call in skills.calls] == ["push", "grasp", "push", "grasp"]


def test_reduce_removes_what_is_named_and_nothing_else(play):
    agent = scripted("reduce", "plain", "blue bowl, green book")
    options = ["white cup", "red die", "black pen", "gray tin", "None of the above"]
    hidden = Block(2, (300, 300, 359, 359), 0.02)
    table = [
        hidden,
        Block(1, (250, 250, 449, 449), 0.05, (30, 60, 150)),
        Block(4, (200, 200, 379, 379), 0.09, (40, 120, 50)),
        Block(3, (700, 700, 799, 799), 0.05, (200, 180, 40)),
    ]
    skills = Obedient()
    record = play(agent, options, SPECS, table, skills)
    assert record.answer and record.answer.choice == "B"
    left = {placed.instance for placed in record.scenes[-1].objects}
    assert {2, 3} <= left and len(skills.calls) == 2
