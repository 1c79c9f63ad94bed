import pytest

from probe.agents.baselines import AtOnce, always, always_none, extreme, middle_number
from probe.episodes.run import run_episode
from probe.episodes.turns import Question
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.answer_form import AnswerForm
from probe.toolshed.result import Answer
from probe.toolshed.toolshed import Toolshed
from tabletops import Block, Obedient, PaintedStation, spec

SPECS = {1: spec("blue bowl", "blue"), 2: spec("red die", "red")}
BLOCKS = [Block(1, (300, 300, 499, 499)), Block(2, (600, 700, 700, 800))]
NONE = "None of the above"
SIZES = {"plum": 0.05, "nut": 0.03, "egg": 0.06, "pea": 0.01}


def asked(*options: str) -> Question:
    return Question("?", tuple(zip("ABCDE", options, strict=False)))


@pytest.mark.parametrize("letter", ["A", "C", "E"])
def test_one_call_and_the_episode_is_over(play, letter):
    record = play(AtOnce(always(letter)), ["v", "w", "x", "y", NONE], SPECS, BLOCKS)
    assert record.end == "answered" and record.answer.choice == letter
    assert [step.call.name for step in record.steps] == ["answer_question"]
    assert record.manipulations == 0


def test_without_a_letter_it_stops(play):
    record = play(AtOnce(always_none), ["Object A", "Object B"], SPECS, BLOCKS)
    assert record.end == "stopped" and record.steps == ()


def test_a_letter_that_is_not_offered_becomes_the_last_one():
    assert always("E")(asked("Object A", "Object B")) == "B"
    assert always("A")(asked("Object A", "Object B")) == "A"


def test_none_is_found_by_its_words():
    assert always_none(asked("v", "w", NONE)) == "C"


@pytest.mark.parametrize(
    ("numbers", "letter"), [(("4", "0", "2", "5"), "C"), (("0", "1", "2", "3"), "B")]
)
def test_the_middle_number_is_the_lower_of_two(numbers, letter):
    assert middle_number(asked(*numbers, NONE)) == letter


def test_the_middle_of_what_are_no_numbers_is_the_first():
    assert middle_number(asked("plum", "nut", NONE)) == "A"


def test_sizes_go_by_name_and_leave_out_what_has_none():
    question = asked("plum", "nut", "unheard of", "egg", NONE)
    assert extreme(SIZES, {}, largest=False)(question) == "B"
    assert extreme(SIZES, {}, largest=True)(question) == "D"


def test_sizes_of_numbers_are_the_numbers():
    question = asked("3", "0", "5", "1", NONE)
    assert extreme(SIZES, {}, largest=False)(question) == "B"
    assert extreme(SIZES, {}, largest=True)(question) == "C"


def test_of_marked_things_what_shows_decides():
    question, areas = asked("Object A", "Object B"), {"A": 700, "B": 900}
    assert extreme(SIZES, areas, largest=True)(question) == "B"
    assert extreme(SIZES, areas, largest=False)(question) == "A"


def test_asked_for_a_point_it_says_the_same_again():
    form = AnswerForm(tuple("ABCDE"), tuple("ABCD"))
    tools = Toolshed(PaintedStation(BLOCKS), Oracle(SPECS), Obedient(), UR5_TABLE, form=form)
    agent = AtOnce(always("C"))
    question = asked("v", "w", "x", "y", NONE)
    record = run_episode("t", question, agent, tools, PaintedStation(BLOCKS), agent_name="a")
    assert [step.status for step in record.steps] == ["malformed", "done"]
    assert record.answer == Answer("C", None)
