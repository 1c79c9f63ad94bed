from __future__ import annotations

import json
from dataclasses import replace

import pytest

from lessons import lesson, training_task
from probe.episodes.participation import ModelReply
from probe.episodes.turns import Call
from probe.errors import BadData
from probe.tasks.suite_file import CANARY
from probe.train.dataset.examples import Canary, example_of
from probe.train.dataset.rows import trl_row
from probe.transcripts.messages import messages
from probe.transcripts.tools import as_sent
from train.conftest import LESSONS, shown_in


def test_an_example_ends_with_the_last_reply_and_is_told_as_models_are(examples):
    for it, example in zip(LESSONS, examples, strict=True):
        pictures = shown_in(it)
        told = messages(it.record, pictures.first, pictures.later)
        count = len(example.messages)
        assert list(map(repr, example.messages)) == list(map(repr, told[:count]))
        assert example.messages[-1].role == "assistant"
        assert all(message.role != "assistant" for message in told[count:])
        assert example.pictures == pictures.all


def test_words_and_calls_are_the_assistants(examples):
    said = [message for message in examples[0].messages if message.role == "assistant"]
    assert [message.text for message in said[:2]] == ["I want the mug.", "I take it."]
    assert said[0].calls[0][1].arguments == '{"description": "mug"}'


def test_tools_come_along_where_there_are_any(examples):
    assert json.loads(examples[0].tools) == as_sent("pixels")
    assert examples[1].tools == ""
    assert [example.setting for example in examples] == ["agentic", "direct", "agentic"]


def test_places_are_counted_as_the_student_counts_them():
    task = training_task(1)
    it = lesson(task, setting="direct")
    seat = it.record.participation
    assert seat is not None
    reply = replace(seat.replies[0], words="There.\nANSWER: B (512, 256)")
    record = replace(it.record, participation=replace(seat, replies=(reply,)))
    example = example_of(task, record, shown_in(it), "0-1000")
    assert example.messages[-1].text == "There.\nANSWER: B (500, 250)"
    assert "thousandths" in example.messages[0].text
    counted = replace(record, participation=replace(seat, points="0-1000"))
    with pytest.raises(BadData, match="Say --points 0-1000"):
        example_of(task, counted, shown_in(it), "pixels")


def test_words_along_with_calls_count_places_as_the_calls_do():
    """What a teacher says beside a call stands in the call; what it says alone, in its reply."""
    it = lesson(training_task(1))
    find, *others = it.record.steps
    call = Call.of("find_object", {"description": "the mug at (512, 256)"}, "I see it: (512, 256).")
    record = replace(it.record, steps=(replace(find, call=call), *others))
    thousandths = example_of(it.task, record, shown_in(it), "0-1000").messages[2]
    assert thousandths.text == "I see it: (500, 250)."
    assert json.loads(thousandths.calls[0][1].arguments)["description"] == "the mug at (500, 250)"
    assert example_of(it.task, record, shown_in(it), "pixels").messages[2].text == call.words
    # A teacher that counted thousandths said so itself.
    assert record.participation is not None
    counted = replace(record, participation=replace(record.participation, points="0-1000"))
    assert example_of(it.task, counted, shown_in(it)).messages[2].text == call.words


@pytest.mark.parametrize(
    ("status", "learnt"), [("done", 1), ("failed", 1), ("malformed", 0), ("refused", 0)]
)
def test_a_reply_with_a_call_that_did_nothing_is_not_learnt(status, learnt):
    it = lesson(training_task(1), statuses=[("mug", status), ("pot", "done")])
    assert [step.status for step in it.record.steps].index(status, 1) == 1
    seat = it.record.participation
    assert seat is not None
    alone = [ModelReply(1) for _ in it.record.steps]
    for replies, first in (
        (alone, [1, learnt, 1, 1, 1]),
        ([ModelReply(2), *alone[2:]], [learnt, 1, 1, 1]),
    ):
        record = replace(it.record, participation=replace(seat, replies=tuple(replies)))
        rows = trl_row(example_of(it.task, record, shown_in(it)))["messages"]
        assert [row["weight"] for row in rows if row["role"] == "assistant"] == first
        assert {row["weight"] for row in rows if row["role"] != "assistant"} == {None}


def test_a_canary_in_a_text_is_refused():
    it = lesson(training_task(1))
    step = replace(it.record.steps[0], text=f"a file says: {CANARY}")
    record = replace(it.record, steps=(step, *it.record.steps[1:]))
    with pytest.raises(Canary, match="canary of the suites"):
        example_of(it.task, record, shown_in(it))
