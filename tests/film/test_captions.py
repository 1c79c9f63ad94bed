"""What a film says of calls and results."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.turns import Call, Question
from probe.film.captions import Caption, call_words, captions_of
from probe.film.footage import FilmedCall, Footage
from probe.film.watched_world import TableMoment
from probe.tasks.grading import Score
from probe.toolshed.result import Answer, ToolResult
from task_examples import FIND, SCENE

RIGHT, WRONG = Score(True, True, "right"), Score(False, False, "wrong")


def footage(answer: Answer | None, *calls: tuple[Call, ToolResult]) -> Footage:
    question = Question("Which?", ())
    state = TableState(SCENE, (0.0,) * 6)
    record = EpisodeRecord("t", "me", 0, question, state, (), answer, "answered")
    moment = TableMoment(0.0, np.zeros(6), 0.1, SCENE.objects)
    filmed = tuple(FilmedCall(call, result, 0, 0) for call, result in calls)
    return Footage(FIND, record, question, (moment,), filmed)


def captions(made: Footage, score: Score) -> tuple[Caption, ...]:
    return captions_of(made.calls, made.record, score)


LOOK = (Call.of("perceive_scene", words="Hm."), ToolResult("objects:\n- number: 1\n- number: 2\n"))
PUSH = (
    Call.of("push", {"object_id": "object_3", "distance_cm": 5}),
    ToolResult("Failed: it is out of reach.", status="failed"),
)
ANSWER = (Call.of("answer_question", {"choice": "B"}), ToolResult("Your answer is recorded."))


def test_each_call_has_its_caption():
    look, push, answer = captions(footage(Answer("B"), LOOK, PUSH, ANSWER), RIGHT)
    assert (look.heading, look.words, look.call) == ("Call 1 of 3", "Hm.", "perceive_scene()")
    assert (look.result, look.bad) == ("A list of 2 things.", False)
    assert push.call == "push(object_id=object_3, distance_cm=5)"
    assert (push.result, push.bad) == ("Failed: it is out of reach.", True)
    assert (answer.result, answer.bad) == ("Answer B: right.", False)


def test_a_wrong_answer_is_called_so():
    (answer,) = captions(footage(Answer("B"), ANSWER), WRONG)
    assert (answer.result, answer.bad) == ("Answer B: wrong.", True)
    (open_end,) = captions(footage(None, LOOK), WRONG)
    assert (open_end.result, open_end.bad) == ("A list of 2 things.", False)


def test_what_isn_t_a_mapping_is_shown_as_it_was_sent():
    assert call_words(Call("push", "[1, 2]")) == "push([1, 2])"
    assert call_words(Call("push", "not JSON")) == "push(not JSON)"


def test_texts_are_short_and_harmless():
    long = replace(LOOK[0], words="word " * 300)
    (caption,) = captions(footage(None, (long, ToolResult("\x1b[31mred", status="failed"))), RIGHT)
    assert len(caption.words) <= 420 and caption.words.endswith("...")
    assert "\x1b" not in caption.result
