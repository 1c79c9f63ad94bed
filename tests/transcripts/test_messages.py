"""Records as messages."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.episodes.participation import ModelReply, Participation
from probe.episodes.turns import Question
from probe.transcripts.messages import (
    PICTURE_FOLLOWS,
    OtherPictures,
    messages,
    opening,
    pictureless_first,
)
from run_folders import DEMO, episode

TASK = DEMO.tasks[0]
RECORD = episode(TASK)
FIND, GRASP = b"found", b"grasped"
LATER = (FIND, GRASP, None, None)


def test_an_agent_without_a_model_is_told_call_by_call():
    told = messages(RECORD, [b"first"], LATER)
    roles = [message.role for message in told]
    assert roles == [
        "system", "user",
        "assistant", "tool", "user",
        "assistant", "tool", "user",
        "assistant", "tool",
        "assistant", "tool",
    ]  # fmt: skip
    assert told[1].pictures == (b"first",) and told[1].text.startswith(TASK.question)
    assert told[1].text.endswith(f"{TASK.options[-1].letter}: {TASK.options[-1].text}")
    assert told[3].text == f"{RECORD.steps[0].text}\n{PICTURE_FOLLOWS}"
    assert told[4].pictures == (FIND,) and told[4].text == ""
    assert [message.call_id for message in told if message.role == "tool"] == [
        "call_1", "call_2", "call_3", "call_4",
    ]  # fmt: skip


def test_a_question_that_allows_fewer_manipulations_is_not_contradicted():
    ten, three = (
        opening("agentic", "pixels", Question("?", (), manipulations=number), ())[0].text
        for number in (None, 3)
    )
    assert "10 of them may be grasps or pushes" in ten and "10" not in three.replace("1024", "")
    assert "3 of them may be grasps or pushes" in three


def test_replies_are_told_as_they_were():
    replies = (ModelReply(0, "Hm."), ModelReply(1), ModelReply(3))
    told = messages(
        replace(RECORD, participation=Participation("agentic", replies=replies)), [b"first"], LATER
    )
    roles = [message.role for message in told]
    assert roles == [
        "system", "user",
        "assistant", "user",
        "assistant", "tool", "user",
        "assistant", "tool", "tool", "tool", "user",
    ]  # fmt: skip
    assert told[2].text == "Hm." and "called no tool" in told[3].text
    last = told[-5]
    assert [id for id, _ in last.calls] == ["call_2", "call_3", "call_4"]
    # Results with a picture come after those without.
    assert [message.call_id for message in told[-4:-1]] == ["call_3", "call_4", "call_2"]
    assert told[-1].pictures == (GRASP,)


def test_arguments_that_are_no_object_are_left_out():
    told = messages(RECORD, [b"first"], LATER)
    (_, call) = told[8].calls[0]
    assert RECORD.steps[2].call.arguments == "I look for it." and call.arguments == "{}"


def test_an_episode_in_words():
    seat = Participation("direct", replies=(ModelReply(0, "Hm."), ModelReply(0, "ANSWER: B")))
    record = replace(RECORD, steps=(), participation=seat)
    told = messages(record, [b"first"])
    assert [message.role for message in told] == [
        "system",
        "user",
        "assistant",
        "user",
        "assistant",
    ]
    assert "ANSWER: X" in told[3].text and told[4].text == "ANSWER: B"


def test_pictures_have_to_be_those_of_the_record():
    with pytest.raises(OtherPictures, match="takes? 4 pictures .* not 1"):
        messages(RECORD, [b"first"], [None])


def test_the_order_of_results_is_stable():
    assert pictureless_first([b"a", None, b"c", None]) == [1, 3, 0, 2]
