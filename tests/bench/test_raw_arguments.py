"""A call's arguments are what the model sent; the harness's repairs don't reach the table."""

from __future__ import annotations

import uuid

import anyio
import pytest
from inspect_ai.model import CachePolicy, ChatMessageUser, Model, get_model

from bench.sitting_in import NAME
from model_server import Reply, serving
from probe.bench.model_conversation import ModelConversation
from probe.bench.usage import EpisodeUsage
from probe.bench.wire import call_of, tool_infos
from probe.episodes.turns import Call
from probe.toolshed.parse import parse
from probe.toolshed.refusals import BadArguments

pytestmark = pytest.mark.filterwarnings("default")

MALFORMED = [
    ("grasp_and_remove", "object_1"),
    ("answer_question", "B"),
    ("perceive_scene", "nonsense"),
    ("find_object", '{"description":"mug"}""'),
    ("find_object", '{"description": '),
    ("find_object", '["mug"]'),
    ("answer_question", '"B"'),
    ("find_object", '{"description": "' + "mug " * 8000),
]
"""What the harness would carry out all the same, or cut before it tells of it."""


def reply_to(model: Model) -> tuple[list[Call], list[str]]:
    """The calls of one reply, and the faults that were noted."""
    scopes = {"test": uuid.uuid4().hex}
    policy = CachePolicy(expiry=None, scopes=scopes)

    async def ask(times: int) -> list[ModelConversation]:
        asked: list[ModelConversation] = []
        for _ in range(times):
            first = [ChatMessageUser(content="What is under the mug?")]
            asked.append(
                ModelConversation(model, tool_infos("pixels"), first, policy, None, EpisodeUsage())
            )
            await asked[-1].reply()
        return asked

    fresh, kept = anyio.run(ask, 2)
    said = [[call_of(c, "") for c in it.messages[-1].tool_calls] for it in (fresh, kept)]  # type: ignore[union-attr]
    assert said[0] == said[1], "a reply from the cache is the same"
    assert fresh.seat("agentic", "pixels").faults == kept.seat("agentic", "pixels").faults
    return said[0], list(fresh.seat("agentic", "pixels").faults)


@pytest.mark.parametrize("arguments", [{}, {"responses_api": True}], ids=["chat", "responses"])
def test_malformed_arguments_are_kept_as_they_were_sent_and_refused(arguments):
    name = "openai/gpt-5.4" if arguments else NAME
    with serving(lambda number, body: Reply(calls=tuple(MALFORMED))) as server:
        model = get_model(name, base_url=server.url, api_key="none", memoize=False, **arguments)
        calls, faults = reply_to(model)
    assert sum("tools" in body for body in server.bodies) == 1
    assert [(call.name, call.arguments) for call in calls] == MALFORMED
    for call in calls:
        with pytest.raises(BadArguments):
            parse(call.name, call.values)
    assert faults == [f"reply 1: {n} was called with what is no JSON object" for n, _ in MALFORMED]


def test_whole_arguments_and_none_at_all_are_no_fault():
    sent = (("find_object", '{"description":"mug"}'), ("perceive_scene", ""))
    with serving(lambda number, body: Reply(calls=sent)) as server:
        model = get_model(NAME, base_url=server.url, api_key="none", memoize=False)
        calls, faults = reply_to(model)
    assert [call.values for call in calls] == [{"description": "mug"}, {}]
    assert faults == []
