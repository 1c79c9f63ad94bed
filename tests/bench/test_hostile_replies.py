"""Whatever stands in one reply is answered in words; the evaluation goes on and ends well."""

from __future__ import annotations

import json
from typing import Any

import pytest
from inspect_ai import eval as evaluate
from inspect_ai.model import get_model

from bench.painted import PaintedPlace, demo, plan
from bench.sitting_in import FIND, answer, kept, replies_so_far, run_in, seat_of, values_of
from model_server import Reply, serving
from policy_server import task_of
from probe.bench.harness import harness_task
from probe.bench.model_runner import ModelRunner

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(2)
HOSTILE, CALM = SUITE.tasks
HALF = "\ud800"
DEEP = 100_000

REPLIES = {
    "half a pair as a choice": Reply(calls=(("answer_question", '{"choice": "\\ud800"}'),)),
    "half a pair on the wire": Reply(calls=(("answer_question", f'{{"choice": "{HALF}"}}'),)),
    "half a pair in words": Reply(f"I look {HALF} there.", calls=(("push", "{}"),)),
    "half a pair as the tool": Reply(calls=((HALF, "{}"),)),
    "half a pair as a key": Reply(calls=(("push", '{"a": {"\\udfff": ["\\ud800"]}}'),)),
    "NUL and controls": Reply(
        "\0\x1b[2J\x07", calls=(("push\0", '{"\\u0000\\u001b": "\\u0007"}'),)
    ),
    "a number past any float": Reply(calls=(("push", '{"distance_cm": 1e999}'),)),
    "no number at all": Reply(calls=(("push", '{"distance_cm": NaN, "direction": -Infinity}'),)),
    "deep lists": Reply(calls=(("push", f'{{"a": {"[" * DEEP}{"]" * DEEP}}}'),)),
    "deep objects": Reply(calls=(("push", '{"a":' * DEEP + "1" + "}" * DEEP),)),
    "fairly deep": Reply(calls=(("push", '{"a":' * 300 + "1" + "}" * 300),)),
    "10 MB": Reply(calls=(("find_object", json.dumps({"description": "x" * 10_000_000})),)),
    "a list": Reply(calls=(("push", '["object_1", "left", 10]'),)),
    "a text": Reply(calls=(("push", '"left"'),)),
    "null": Reply(calls=(("push", "null"),)),
    "no name": Reply(calls=(("", "{}"),)),
    "a long name": Reply(calls=(("x" * 1_000_000, "{}"),)),
    "the same id twice": Reply(calls=(("push", "{}"), ("push", "{}")), ids=("same", "same")),
    "an empty id": Reply(calls=(("push", "{}"),), ids=("",)),
    "half a pair as an id": Reply(calls=(("push", "{}"),), ids=(HALF,)),
}


def script(hostile: Reply):
    def say(number: int, body: dict[str, Any]) -> Reply:
        task, turn = task_of(body, SUITE), replies_so_far(body)
        if task is HOSTILE and turn == 0:
            return hostile
        if task is CALM and turn == 0:
            return Reply(calls=(FIND,))
        return Reply(calls=(answer(task.answer),))

    return say


@pytest.mark.parametrize("name", REPLIES)
def test_one_reply_never_stops_an_evaluation(tmp_path, name):
    with serving(script(REPLIES[name])) as server:
        log = run_in(plan(tmp_path, "agentic", SUITE), server.url, max_retries=0)
    assert log.status == "success"
    records = kept(tmp_path)
    assert set(records) == {HOSTILE.id, CALM.id}
    *odd, last = records[HOSTILE.id].steps
    assert [step.status for step in odd] == ["malformed"] * len(REPLIES[name].calls)
    assert records[HOSTILE.id].end == "answered" and last.call.name == "answer_question"
    assert records[HOSTILE.id].fault is None
    assert values_of(log) == {HOSTILE.id: "C", CALM.id: "C"}


def test_a_number_that_no_client_reads_is_a_reply_without_a_call(tmp_path):
    """Python reads no number of over 4,300 digits; the client fails where we have no say."""
    huge = Reply(calls=(("push", f'{{"distance_cm": {"9" * 5000}}}'),))
    with serving(script(huge)) as server:
        log = run_in(plan(tmp_path, "agentic", SUITE), server.url, max_retries=0)
        told = json.dumps(server.bodies)
    assert values_of(log) == {HOSTILE.id: "C", CALM.id: "C"}
    (fault,) = seat_of(kept(tmp_path)[HOSTILE.id]).faults
    assert fault == "reply 1: can't be read: a number in it has too many digits"
    assert "That reply called no tool." in told


def test_errors_and_replies_without_a_choice_are_faults_of_their_episode(tmp_path):
    odd = Reply(status=400, error=f"no {HALF} such thing")
    with serving(script(odd)) as server:
        log = run_in(plan(tmp_path / "error", "agentic", SUITE), server.url, max_retries=0)
    assert values_of(log) == {HOSTILE.id: "missing", CALM.id: "C"}
    fault = kept(tmp_path / "error")[HOSTILE.id].fault or ""
    assert "gave no reply 1" in fault and "400" in fault and "no ? such thing" in fault, fault
    with serving(script(Reply(choices=0))) as server:
        log = run_in(plan(tmp_path / "none", "agentic", SUITE), server.url, max_retries=0)
    assert values_of(log) == {HOSTILE.id: "missing", CALM.id: "C"}
    assert kept(tmp_path / "none")[HOSTILE.id].end == "fault"


@pytest.mark.parametrize(
    ("name", "base", "arguments"),
    [
        ("openai/gpt-5.4", "/v1", {"responses_api": True}),
        ("anthropic/claude-opus-4-7", "", {"streaming": False}),
        ("google/gemini-3.1-pro-preview", "", {}),
    ],
)
@pytest.mark.parametrize("which", ["half a pair as a choice", "half a pair in words", "deeper"])
def test_other_protocols(tmp_path, name, base, arguments, which):
    deeper = Reply(calls=(("push", '{"a":' * 500 + "1" + "}" * 500),))
    hostile, begun = REPLIES.get(which, deeper), list[int]()

    def say(number: int, body: dict[str, Any]) -> Reply:
        if "push" not in json.dumps(body.get("tools", "")):
            return Reply("hello, world")
        begun.append(number)
        return hostile if len(begun) == 1 else Reply(calls=(answer("E"),))

    with serving(say) as server:
        url = server.url.removesuffix("/v1") + base
        model = get_model(name, base_url=url, api_key="none", memoize=False, **arguments)
        asked = plan(tmp_path, "agentic", demo(1))
        runner = ModelRunner(asked, PaintedPlace)
        (log,) = evaluate(
            harness_task(asked, runner), model=model, display="none", max_retries=0,
            log_dir=str(tmp_path / "logs"), max_tokens=1000,
        )  # fmt: skip
        runner.close()
    assert log.status == "success"
    (record,) = kept(tmp_path).values()
    calls = [reply.calls for reply in seat_of(record).replies]
    assert record.end == "answered" and len(calls) == 2, record.fault
    # Where arguments are no text on the wire, the client can't read what is nested too deep.
    assert [step.status for step in record.steps] == ["malformed", "done"][1 - calls[0] :]
    assert calls[0] == 1 or which == "deeper"
