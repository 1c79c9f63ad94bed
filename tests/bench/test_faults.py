"""Whatever a server or a model does, the evaluation ends and every episode is accounted for."""

from __future__ import annotations

import json
import math

import pytest

from bench.painted import demo, plan
from bench.sitting_in import FIND, GRASP, LOOK, answer, kept, replies_so_far, run_in
from model_server import Reply, serving
from policy_server import task_of
from probe.scores.marking import roster_of_tasks, row_of
from probe.scores.summary import summarise
from probe.tasks.grading import Score
from run_folders import wrong_letter

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

PATIENCE = 15
"""Seconds for one attempt: a busy machine must not be taken for a server that hangs."""

SUITE = demo()
FIRST, BROKEN, MUTE, TWICE, DOWN, SLOW = SUITE.tasks


class Misfortunes:
    """Finds the ball, removes it, answers right; a different thing goes wrong in each task."""

    def __init__(self) -> None:
        self.hits: dict[str, int] = {}

    def __call__(self, number: int, body: dict) -> Reply:
        task = task_of(body, SUITE)
        hits = self.hits[task.id] = self.hits.get(task.id, 0) + 1
        if task is DOWN:
            return Reply(status=500)
        if task is FIRST and hits == 1:
            return Reply(status=429)
        if task is SLOW and hits == 1:
            return Reply(words="too late", wait=1.6 * PATIENCE)
        if task is MUTE:
            return Reply("")
        return self.move(task, replies_so_far(body))

    def move(self, task, turn: int) -> Reply:
        # Find's right letter would have to be looked at, and painted tables can't be drawn.
        last = answer(wrong_letter(task) if task.question_type == "find" else task.answer)
        if task is BROKEN:
            broken = [("find_object", '{"description": '), ("juggle", "{}"), last]
            return Reply(calls=(broken[turn],))
        if task is TWICE:
            return Reply("Both.", calls=[(("push", "{}"), FIND), (GRASP, LOOK), (last,)][turn])
        return Reply("Well.", calls=((FIND, GRASP, last)[turn],))


@pytest.fixture(scope="module")
def played(tmp_path_factory):
    out = tmp_path_factory.mktemp("faults")
    script = Misfortunes()
    with serving(script) as server:
        log = run_in(
            plan(out, "agentic", SUITE), server.url, max_retries=1, attempt_timeout=PATIENCE
        )
    return log, kept(out), script


def test_nothing_leaves_the_denominator(played):
    log, records, _ = played
    assert log.status == "success"
    assert set(records) == {task.id for task in SUITE.tasks}
    assert len(log.samples) == len(SUITE.tasks)
    assert [sample.error for sample in log.samples] == [None] * 6


def test_no_number_while_something_is_missing(played):
    log, records, _ = played
    metrics = log.results.scores[0].metrics
    assert metrics["missing"].value == 1
    assert math.isnan(metrics["macro"].value)
    roster = roster_of_tasks(SUITE.tasks)
    worth = Score(False, False, "wrong")
    rows = [
        row_of(task, records[task.id], worth, suite="small", setting="agentic")
        for task in SUITE.tasks
        if records[task.id].answer is None
    ]
    card = summarise("small", rows, roster).cards[0]
    assert card.macro.headline.value is None


def test_faults_are_in_the_records(played):
    _, records, script = played
    assert records[DOWN.id].end == "fault"
    assert "no reply 1" in records[DOWN.id].fault
    assert script.hits[DOWN.id] >= 2
    for task in (FIRST, SLOW):
        (fault,) = records[task.id].participation.faults
        assert fault.startswith("reply 1: the server failed once")
    assert records[BROKEN.id].participation.faults == (
        "reply 1: find_object was called with what is no JSON object",
    )
    assert records[MUTE.id].participation.faults == ("reply 1: empty", "reply 2: empty")
    assert records[MUTE.id].end == "stopped"


def test_malformed_calls_take_a_turn_and_are_kept_as_they_were_sent(played):
    _, records, _ = played
    steps = records[BROKEN.id].steps
    assert [step.status for step in steps[:2]] == ["malformed", "malformed"]
    assert steps[0].call.arguments == '{"description": '
    assert steps[1].call.name == "juggle"
    assert records[BROKEN.id].end == "answered"


def test_two_calls_in_a_reply_are_two_turns(played):
    _, records, _ = played
    record = records[TWICE.id]
    names = [step.call.name for step in record.steps]
    assert names == ["push", "find_object", "grasp_and_remove", "perceive_scene", "answer_question"]
    assert [reply.calls for reply in record.participation.replies] == [2, 2, 1]
    assert (record.participation.tokens_in, record.participation.tokens_out) == (300, 30)
    said = [json.loads(step.call.arguments) for step in record.steps]
    assert said[1] == {"description": "white ball"}


def test_scores_are_the_graders(played):
    log, _, _ = played
    values = {sample.id: sample.scores["probe"].value for sample in log.samples}
    assert values[FIRST.id] == "C" and values[MUTE.id] == "I" and values[DOWN.id] == "missing"
