"""Answers in words: what is asked for once more, and what stands in the end."""

from __future__ import annotations

from dataclasses import replace
from uuid import uuid4

import anyio
import pytest
from inspect_ai.model import CachePolicy, ChatMessageSystem, get_model

from bench.sitting_in import NAME
from model_server import Reply, serving
from probe.bench.conversation import in_words
from probe.bench.model_conversation import ModelConversation
from probe.bench.usage import EpisodeUsage
from probe.episodes.participation import Participation
from probe.tasks.suite_file import demo_suite
from probe.toolshed.result import Answer
from probe.transcripts.messages import messages
from probe.transcripts.prompts import reminder
from run_folders import episode

FIND, COUNT = (
    next(task for task in demo_suite().tasks if task.question_type == question_type)
    for question_type in ("find", "count")
)
WORDS, POINT = reminder("direct"), reminder("direct", answered=True)


def asked(task, *said: str) -> tuple[Answer | None, ModelConversation]:
    """What comes of replies, and the conversation."""
    cache = CachePolicy(expiry=None, scopes={"test": uuid4().hex})
    with serving(lambda number, body: Reply(said[number])) as server:
        model = get_model(NAME, base_url=server.url, api_key="none", memoize=False)
        first = [ChatMessageSystem(content="Answer.")]
        conversation = ModelConversation(model, [], first, cache, None, EpisodeUsage())
        return anyio.run(in_words, conversation, "direct", task, "pixels"), conversation


@pytest.mark.parametrize(
    ("task", "said", "reminded", "answer"),
    [
        (FIND, ["ANSWER: B (5, 6)"], [], Answer("B", (5.0, 6.0))),
        (FIND, ["ANSWER: E"], [], Answer("E")),
        (COUNT, ["ANSWER: B"], [], Answer("B")),
        (FIND, ["ANSWER: B", "ANSWER: B at (5, 6)"], [POINT], Answer("B", (5.0, 6.0))),
        (FIND, ["ANSWER: B", "ANSWER: C"], [POINT], Answer("C")),
        (FIND, ["ANSWER: B", "I can't."], [POINT], Answer("B")),
        (FIND, ["Hm.", "ANSWER: B"], [WORDS], Answer("B")),
        (COUNT, ["Hm.", "Hm."], [WORDS], None),
    ],
)
def test_what_is_lacking_is_asked_for_once(task, said, reminded, answer):
    found, conversation = asked(task, *said)
    assert found == answer
    assert [it.text for it in conversation.messages if it.role == "user"] == reminded
    seat = Participation("direct", replies=tuple(conversation.replies))
    record = replace(episode(task), steps=(), participation=seat)
    assert [it.text for it in messages(record, [b""])[2:]] == [
        it.text for it in conversation.messages[1:]
    ]
