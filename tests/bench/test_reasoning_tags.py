"""A reply full of tags costs no more than any other, in whichever protocol it comes."""

from __future__ import annotations

import time
from typing import Any

import anyio
import pytest
from inspect_ai.model import ContentReasoning, GenerateConfig, ModelOutput, get_model

from bench.painted import demo, plan
from bench.sitting_in import NAME, answer, kept, replies_so_far, run_in, seat_of, values_of
from model_server import Reply, serving
from policy_server import task_of
from probe.bench.evaluation import greet
from probe.bench.raw_arguments import as_sent
from probe.bench.reasoning_tags import TooManyTags, check_tags

pytestmark = pytest.mark.filterwarnings("default")

TAGS = 100_000
FULL = "<think>" * TAGS
FEW_S = 10.0
"""On a busy machine; without a bound each of these takes minutes, or hours."""

ODD = {
    "opened": FULL,
    "never closed": "<think" * TAGS,
    "summaries": f"<think>{'<summary>' * TAGS}</think>",
    "closed too seldom": f"{FULL}{'</think>' * (TAGS - 1)}",
}


def asked(name: str, words: str, base: str = "/v1", **arguments: Any) -> tuple[ModelOutput, float]:
    """What a model's provider makes of words, and how long that took."""

    async def ask() -> ModelOutput:
        async with model:
            return await model.generate(
                "Well?", config=GenerateConfig(max_retries=0, max_tokens=1000)
            )

    with serving(lambda number, body: Reply(words)) as server:
        url = server.url.removesuffix("/v1") + base
        model = get_model(name, base_url=url, api_key="none", memoize=False, **arguments)
        as_sent(model)
        begun = time.monotonic()
        return anyio.run(ask), time.monotonic() - begun


@pytest.mark.parametrize("words", ODD.values(), ids=ODD)
def test_tags_without_end_are_a_reply_that_cannot_be_read(words):
    output, took = asked(NAME, words)
    assert took < FEW_S
    assert "tags of reasoning" in (output.error or "")
    assert output.completion == "" and not output.message.tool_calls


def test_openais_own_chat_is_bounded_as_well():
    output, took = asked("openai/gpt-4o", FULL, responses_api=False)
    assert took < FEW_S and f"{TAGS:,} tags of reasoning" in (output.error or "")


@pytest.mark.parametrize("words", [FULL, "<internal>" * TAGS, "<internal>no data</internal>"])
def test_anthropics_words_stay_as_they_are(words):
    output, took = asked("anthropic/claude-opus-4-7", words, base="", streaming=False)
    assert took < FEW_S
    assert output.error is None and output.completion == words


def test_reasoning_is_told_apart_as_ever():
    long = "hm " * 100_000
    output, _ = asked(NAME, f"<think>{long}</think>ANSWER: B")
    assert output.completion == "ANSWER: B"
    thought = output.message.content[0]
    assert isinstance(thought, ContentReasoning) and thought.reasoning == long.strip()
    assert output.error is None


def test_what_may_be_looked_through():
    check_tags("x" * 10_000_000)
    check_tags("<think>" + "x" * 10_000_000)
    check_tags("<think>well</think>" * 500)
    with pytest.raises(TooManyTags, match="10,000 tags of reasoning in 70,000 characters"):
        check_tags("<think>" * 10_000)


def test_a_greeting_full_of_tags_stops_nothing():
    with serving(lambda number, body: Reply(FULL)) as server:
        model = get_model(NAME, base_url=server.url, api_key="none", memoize=False)
        begun = time.monotonic()
        greet([model])
    assert time.monotonic() - begun < FEW_S


@pytest.mark.slow
@pytest.mark.parametrize("calls", [(), (("push", "{}"),)], ids=["words", "with a call"])
def test_other_episodes_go_on(tmp_path, calls):
    suite = demo(2)
    hostile, calm = suite.tasks

    def say(number: int, body: dict[str, Any]) -> Reply:
        task = task_of(body, suite)
        if task is hostile and replies_so_far(body) == 0:
            return Reply(FULL, calls=calls)
        return Reply(calls=(answer(task.answer),))

    with serving(say) as server:
        log = run_in(plan(tmp_path, "agentic", suite), server.url, max_retries=0)
        reminders = str(server.bodies).count("That reply called no tool.")
    assert log.status == "success" and reminders == 1
    assert values_of(log) == {hostile.id: "C", calm.id: "C"}
    seat = seat_of(kept(tmp_path)[hostile.id])
    assert [reply.calls for reply in seat.replies] == [0, 1]
    told = "reply 1: can't be read: it has 100,000 tags of reasoning in 700,000 characters"
    assert [fault for fault in seat.faults if fault.startswith(told)] == list(seat.faults) != []
