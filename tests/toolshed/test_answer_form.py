"""An answer that lacks something is refused, with what it lacks; never taken as it isn't."""

import pytest

from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.answer_form import AnswerForm
from probe.toolshed.result import Answer
from probe.toolshed.toolshed import TURNS, Toolshed

LETTERS = ("A", "B", "C", "D", "E")
POINTING = AnswerForm(LETTERS, LETTERS[:4])
PAIR = AnswerForm(("A", "B"))


@pytest.fixture
def asked(station, skills, specs):
    """A function: what a complete answer is to the tools."""

    def make(form: AnswerForm) -> Toolshed:
        return Toolshed(station, Oracle(specs), skills, UR5_TABLE, pictures=False, form=form)

    return make


def answered(shed: Toolshed, choice: str, *point: float):
    return shed.call("answer_question", {"choice": choice} | ({"point": point} if point else {}))


def test_a_missing_point_is_asked_for_once(asked):
    shed = asked(POINTING)
    told = answered(shed, "B")
    assert (told.status, told.ended, shed.answer, shed.turns) == ("malformed", False, None, 1)
    assert told.text.startswith(
        "This question asks you to point at something: give point=[u, v] as well"
    )
    assert "Nothing is recorded yet" in told.text
    again = answered(shed, "B")
    assert (again.status, again.ended, shed.turns) == ("done", True, 2)
    assert shed.answer == Answer("B", None)


def test_a_point_that_comes_later_is_taken(asked):
    shed = asked(POINTING)
    answered(shed, "B")
    assert shed.call("perceive_scene", {}).status == "done"
    assert answered(shed, "C", 12, 34).ended
    assert shed.answer == Answer("C", (12, 34))


def test_what_cannot_be_pointed_at_needs_no_point(asked):
    shed = asked(POINTING)
    assert answered(shed, "E").ended and shed.answer == Answer("E")


def test_questions_that_ask_for_no_point_need_none(asked):
    shed = asked(AnswerForm(LETTERS))
    assert answered(shed, "B").ended and shed.answer == Answer("B")


def test_a_letter_that_is_not_offered_is_refused_each_time(asked):
    shed = asked(PAIR)
    for _ in range(3):
        told = answered(shed, "E")
        assert (told.status, told.ended, shed.answer) == ("malformed", False, None)
        assert "this question has no option E. Its options are A and B." in told.text
    assert answered(shed, "b").ended and shed.answer == Answer("B")


def test_neither_letter_nor_point_costs_the_reminder_of_the_other(asked):
    shed = asked(AnswerForm(LETTERS[:4], LETTERS[:4]))
    assert "no option E" in answered(shed, "E").text
    assert "point at something" in answered(shed, "A").text
    assert "no option E" in answered(shed, "E").text
    assert answered(shed, "A").ended


@pytest.mark.parametrize("point", [(1024, 5), (5, 1024), (-1, 5), (float("nan"), 5)])
def test_a_point_outside_the_picture_is_refused_each_time(asked, point):
    shed = asked(POINTING)
    for _ in range(2):
        told = answered(shed, "B", *point)
        assert (told.status, told.ended, shed.answer) == ("malformed", False, None)
        assert "'point'" in told.text


def test_at_the_last_turn_an_answer_without_a_point_is_better_than_none(asked):
    shed = asked(POINTING)
    for _ in range(TURNS - 1):
        shed.call("perceive_scene", {})
    assert answered(shed, "B").ended and shed.answer == Answer("B")
