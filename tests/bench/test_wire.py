"""What a server gets is what the record tells: asking and training see the same messages."""

from __future__ import annotations

import base64
from typing import Any

import pytest

from bench.painted import demo, plan, shown
from bench.sitting_in import (
    GRASP,
    NAME,
    answer,
    kept,
    replies_so_far,
    run_in,
    seat_of,
    values_of,
)
from model_server import Reply, serving
from probe.bench.prices import Price
from probe.toolshed.tools import tool_schemas
from probe.transcripts.messages import messages

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)
(TASK,) = SUITE.tasks
MUG = ("find_object", '{"description": "red mug"}')
PLACE = ("find_object", '{"description": "the thing at (625, 475)"}')


def script(number: int, body: dict) -> Reply:
    """Forgets to call; calls a broken one after one with a picture; answers."""
    turn = replies_so_far(body)
    if turn == 0:
        return Reply("I wonder.")
    two = Reply("Look.", calls=(PLACE, ("push", "{}")))
    return (two, Reply(calls=(GRASP, MUG)), Reply(calls=(answer("E"),)))[turn - 1]


def pictures_in(content) -> list[bytes]:
    if isinstance(content, str):
        return []
    urls = [part["image_url"]["url"] for part in content if part["type"] == "image_url"]
    return [base64.b64decode(url.partition(",")[2]) for url in urls]


def words_in(content) -> str:
    if isinstance(content, str):
        return content
    return "\n".join(part["text"] for part in content if part["type"] == "text")


@pytest.mark.parametrize("points", ["pixels", "0-1000"])
def test_the_last_request_is_the_record_told(tmp_path, points):
    with serving(script) as server:
        log = run_in(plan(tmp_path, "agentic", SUITE, points=points), server.url)
    assert log.status == "success"
    record = kept(tmp_path)[TASK.id]
    sent: Any = server.bodies[-1]["messages"]
    calls = [step.call for step in record.steps]
    first, later = shown(plan(tmp_path, "agentic", SUITE, points=points), calls)
    assert [picture is not None for picture in later] == [True, False, True, True, False]
    assert len({first, *later}) == 5
    told = messages(record, [first], later)
    assert len(told) == len(sent) + 2  # the answer and its result come after the last request
    for ours, theirs in zip(told, sent, strict=False):
        assert ours.role == theirs["role"]
        assert ours.text == words_in(theirs["content"] or "")
        assert list(ours.pictures) == pictures_in(theirs["content"] or "")
        names = [
            (c["function"]["name"], c["function"]["arguments"])
            for c in theirs.get("tool_calls", [])
        ]
        assert [(call.name, call.arguments) for _, call in ours.calls] == names
    if points == "0-1000":
        # 625 of 1000 is pixel 640, on the ball.
        assert record.steps[0].call.arguments == '{"description": "the thing at (640, 486.4)"}'
        assert record.steps[0].status == "done"


def test_tools_go_out_as_the_toolshed_words_them(tmp_path):
    with serving(lambda number, body: Reply(calls=(answer("E"),))) as server:
        run_in(plan(tmp_path, "agentic", SUITE), server.url)
    tools: Any = server.bodies[0]["tools"]
    for sent, ours in zip([it["function"] for it in tools], tool_schemas(), strict=True):
        assert (sent["name"], sent["description"]) == (ours.name, ours.description)
        theirs, mine = sent["parameters"], ours.parameters
        assert sorted(theirs.get("required", [])) == sorted(mine.get("required", []))
        assert list(theirs["properties"]) == list(mine["properties"])
        for name, part in mine["properties"].items():
            assert theirs["properties"][name]["description"] == part["description"]


def test_answers_in_words(tmp_path):
    said = ["Hm.", f"So it is.\n**ANSWER: {TASK.answer}**"]
    with serving(lambda number, body: Reply(said[replies_so_far(body)])) as server:
        log = run_in(plan(tmp_path, "direct", SUITE), server.url)
    record = kept(tmp_path)[TASK.id]
    assert record.answer and record.answer.choice == TASK.answer
    assert record.setting == "direct" and record.steps == ()
    assert [reply.words for reply in seat_of(record).replies] == said
    assert values_of(log) == {TASK.id: "C"}
    sent: Any = server.bodies[0]["messages"]
    assert len(pictures_in(sent[1]["content"])) == 1
    assert "tools" not in server.bodies[0]


@pytest.mark.parametrize("called", ["mine", None])
def test_the_record_has_the_cost_by_the_models_name(tmp_path, called):
    price = Price(tokens_in=2, tokens_out=10)
    prices = {called or NAME: price, "another": Price(tokens_in=9, tokens_out=9)}
    with serving(lambda number, body: Reply("ANSWER: E")) as server:
        run_in(plan(tmp_path, "direct", SUITE, called=called, prices=prices), server.url)
    # One reply: 100 tokens in, 10 out.
    assert seat_of(kept(tmp_path)[TASK.id]).cost == pytest.approx(300e-6)


def test_a_limit_of_tokens_ends_an_episode_without_an_answer(tmp_path):
    with serving(script) as server:
        log = run_in(plan(tmp_path, "agentic", SUITE), server.url, token_limit=300)
    record = kept(tmp_path)[TASK.id]
    assert record.end == "stopped" and record.answer is None and record.steps
    assert values_of(log) == {TASK.id: "I"}
    assert log.samples and log.samples[0].limit and log.samples[0].limit.type == "token"
    with serving(script) as server:
        again = run_in(plan(tmp_path, "agentic", SUITE), server.url, token_limit=300)
    assert server.bodies == [] and values_of(again) == {TASK.id: "I"}


def test_who_never_answers_is_wrong_and_refused_pictures_are_missing(tmp_path):
    with serving(lambda number, body: Reply("I can't say.")) as server:
        run_in(plan(tmp_path / "mute", "blind", SUITE), server.url)
    record = kept(tmp_path / "mute")[TASK.id]
    assert record.end == "stopped" and record.answer is None and len(server.bodies) == 2
    with serving(lambda number, body: Reply(status=400)) as server:
        run_in(plan(tmp_path / "refused", "direct", SUITE), server.url, max_retries=0)
    record = kept(tmp_path / "refused")[TASK.id]
    assert record.end == "fault" and "400" in (record.fault or "")
