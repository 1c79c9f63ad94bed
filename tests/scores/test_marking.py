# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

from dataclasses import replace

import pytest

from probe.episodes.conditions import Conditions
from probe.episodes.participation import Participation
from probe.episodes.record import EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call, Question
from probe.scene.visibility import Visibility
from probe.scores.marking import Usage, roster_of_tasks, row_of, stratum_of
from probe.scores.roster import Listed
from probe.tasks.grading import Score
from probe.tasks.task import Certificate
from probe.toolshed.result import Answer
from task_examples import FIND, SCENE

START = TableState(SCENE, (0.0,) * 6)


def step(name: str, status: str = "done") -> Step:
    return Step(Call.of(name), status, "", None, START)  # pyright: ignore[reportArgumentType]


STEPS = (
    step("perceive_scene"),
    step("find_object", "failed"),
    step("find_object", "malformed"),
    step("push", "failed"),
    step("grasp_and_remove"),
    step("grasp_and_remove", "refused"),
    step("answer_question"),
)
RECORD = EpisodeRecord(
    FIND.id,
    "anna",
    2,
    Question("?", ()),
    START,
    STEPS,
    Answer("B", (3.0, 4.0)),
    "answered",
    seconds=Seconds((1.0,) * 7, (0.5,) * 7),
    tools=7,
)
MISSED = Score(correct=False, letter_correct=True, outcome="missed")


def test_a_row_says_what_the_record_and_the_score_say():
    row = row_of(FIND, RECORD, MISSED, suite="v1", setting="agentic", usage=Usage(10, 20, 0.25))
    assert row.model_dump(exclude_none=True) == {
        "suite": "v1",
        "task": "find-0123abcd",
        "kind": "find",
        "stratum": "hidden",
        "options": 5,
        "agent": "anna",
        "arm": "agentic",
        "run": 2,
        "answer": "B",
        "right": "B",
        "correct": False,
        "letter_correct": True,
        "outcome": "missed",
        "end": "answered",
        "turns": 7,
        "manipulations": 2,
        "perceptions": 2,
        "turns_spent": False,
        "manipulations_spent": False,
        "manipulated": True,
        "seconds_agent": 7.0,
        "seconds_tools": 3.5,
        "tokens_in": 10,
        "tokens_out": 20,
        "cost": 0.25,
        "tools": 7,
    }


def test_what_a_model_used_is_in_its_record():
    seat = Participation("agentic", tokens_in=10, tokens_out=20, cost=0.25)
    row = row_of(FIND, replace(RECORD, participation=seat), MISSED, suite="v1", setting="agentic")
    assert (row.tokens_in, row.tokens_out, row.cost) == (10, 20, 0.25)


def test_other_conditions_are_another_arm():
    tilted = replace(RECORD, conditions=Conditions(camera="tilted"))
    row = row_of(FIND, tilted, MISSED, suite="v1", setting="agentic")
    assert row.setting == "agentic, camera tilted"


def test_what_is_unknown_stays_unknown():
    bare = replace(RECORD, seconds=Seconds())
    row = row_of(FIND, bare, MISSED, suite="v1", setting="agentic")
    assert row.seconds_agent is row.seconds_tools is row.tokens_in is row.cost is None
    assert row.exact is row.strict is None


def test_an_answer_without_a_tool_took_no_time_and_no_manipulation():
    bare = replace(RECORD, seconds=Seconds(), steps=())
    row = row_of(FIND, bare, MISSED, suite="v1", setting="direct")
    assert (row.seconds_agent, row.turns, row.manipulated) == (0.0, 0, False)


@pytest.mark.parametrize(("letter", "kept"), [("E", "E"), ("F", None), ("b", None), ("", None)])
def test_a_choice_that_is_no_letter_is_no_answer(letter, kept):
    said = replace(RECORD, answer=Answer(letter))
    wrong = Score(False, False, "wrong")
    assert row_of(FIND, said, wrong, suite="v1", setting="direct").answer == kept


@pytest.mark.parametrize(("fault", "words"), [("Gone: away", "Gone: away"), (None, "unknown")])
def test_our_failure_makes_the_row_missing(fault, words):
    broken = replace(RECORD, answer=None, end="fault", fault=fault)
    row = row_of(FIND, broken, Score(False, False, "unanswered"), suite="v1", setting="agentic")
    assert row.missing
    assert row.fault == words


@pytest.mark.parametrize(("grasps", "spent"), [(9, False), (10, True)])
def test_the_tenth_manipulation_spends_the_budget(grasps, spent):
    busy = replace(RECORD, steps=(step("grasp_and_remove"),) * grasps)
    row = row_of(FIND, busy, MISSED, suite="v1", setting="agentic")
    assert (row.manipulations, row.manipulations_spent) == (grasps, spent)


def test_out_of_turns_spends_the_turns():
    late = replace(RECORD, answer=None, end="out_of_turns")
    row = row_of(FIND, late, Score(False, False, "unanswered"), suite="v1", setting="agentic")
    assert row.turns_spent


@pytest.mark.parametrize(
    ("seen", "stratum"),
    [
        (Visibility(124, 10_000), "hidden"),
        (Visibility(125, 10_000), "partly"),
        (Visibility(50, 1000), "hidden"),
        (Visibility(51, 1000), "partly"),
    ],
)
def test_find_is_parted_by_what_shows_of_the_target(seen, stratum):
    task = replace(FIND, certificate=Certificate({2: seen, 1: Visibility(9, 9)}, {}, ()))
    assert stratum_of(task) == stratum
    assert stratum_of(replace(task, question_type="count")) == ""


def test_the_roster_lists_all_tasks():
    tasks = [FIND, replace(FIND, id="count-1", question_type="count", options=FIND.options[:2])]
    assert roster_of_tasks(tasks) == {
        "find-0123abcd": Listed("find", "hidden", 5),
        "count-1": Listed("count", "", 2),
    }
    stated = replace(FIND.certificate, measures={"necessary": 3.0})
    (listed,) = roster_of_tasks([replace(FIND, certificate=stated)]).values()
    assert listed == Listed("find", "hidden", 5, 3)


@pytest.mark.parametrize(("correct", "strict"), [(True, True), (False, False)])
def test_reduce_says_how_it_was_done(correct, strict):
    gone = replace(
        SCENE.objects[0], pose=replace(SCENE.objects[0].pose, position=(-0.55, -0.44, 0))
    )
    end = TableState(replace(SCENE, objects=(gone, *SCENE.objects[1:])), START.joints)
    done = replace(RECORD, steps=(replace(step("grasp_and_remove"), after=end),), seconds=Seconds())
    score = Score(correct, correct, "right" if correct else "wrong")
    answered = replace(done, answer=Answer("B" if correct else "A"))
    order = replace(FIND, question_type="reduce", named=(1,))
    row = row_of(order, answered, score, suite="v1", setting="agentic")
    assert (row.precision, row.recall, row.exact, row.attempts_a_removal) == (1.0, 1.0, True, 1.0)
    assert (row.others_disturbed, row.strict) == (0, strict)
    more = replace(order, named=(1, 2))
    inexact = row_of(more, answered, score, suite="v1", setting="agentic")
    assert (inexact.exact, inexact.strict) == (False, False)
