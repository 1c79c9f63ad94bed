"""Whatever stands in one reply is answered in words; the evaluation goes on and ends well.

Of each evaluation many tasks hear a reply, each its own: starting tables takes longest.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
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
from probe.episodes.record import EpisodeRecord
from probe.tasks.suite import Suite
from probe.tasks.task import Task

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

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


UNREAD = "a number of 5,000 digits"
"""Python reads no number of over 4,300 digits; the client fails where we have no say."""

UNANSWERED = {
    "an error": Reply(status=400, error=f"no {HALF} such thing"),
    "no choice": Reply(choices=0),
}
BESIDE, CALM = demo(2).tasks
"""One hears a hostile reply, under many ids; the other, beside them, none."""


def hearing(name: str) -> Task:
    """A task of its own that one hostile reply is given to."""
    id = f"beneath-{re.sub('[^a-z0-9]', '-', name.lower())}"
    return replace(BESIDE, id=id, question=f"Hear {name!r}! {BESIDE.question}")


def beside(names: Iterable[str]) -> Suite:
    """A task for each of these replies, and a calm one among them."""
    (*most, last) = map(hearing, names)
    return replace(demo(2), tasks=(*most, CALM, last))


@dataclass(frozen=True)
class Heard:
    """What came of one evaluation in which each of some tasks first hears a reply of its own."""

    status: str
    values: Mapping[str, Any]
    records: Mapping[str, EpisodeRecord]
    told: str


def evaluated(out: Path, replies: Mapping[str, Reply]) -> Heard:
    suite = beside(replies)
    heard = {hearing(name).id: reply for name, reply in replies.items()}
    told = list[str]()

    def say(number: int, body: dict[str, Any]) -> Reply:
        task, turn = task_of(body, suite), replies_so_far(body)
        if task is CALM:
            return Reply(calls=(FIND if turn == 0 else answer(CALM.answer),))
        if hearing(UNREAD).id == task.id:
            told.append(json.dumps(body))
        return Reply(calls=(answer(task.answer),)) if turn else heard[task.id]

    with serving(say, keep=False) as server:
        log = run_in(plan(out, "agentic", suite), server.url, max_retries=0)
    return Heard(log.status, values_of(log), kept(out), "".join(told))


@pytest.fixture(scope="module")
def heard(tmp_path_factory: pytest.TempPathFactory) -> Heard:
    """Of all replies that an episode goes on after."""
    huge = Reply(calls=(("push", f'{{"distance_cm": {"9" * 5000}}}'),))
    return evaluated(tmp_path_factory.mktemp("heard"), REPLIES | {UNREAD: huge})


def test_the_evaluation_goes_on_and_ends_well(heard):
    assert heard.status == "success"
    ids = {hearing(name).id for name in (*REPLIES, UNREAD)}
    assert set(heard.records) == {*ids, CALM.id}
    assert heard.values == dict.fromkeys((*ids, CALM.id), "C")
    assert heard.records[CALM.id].fault is None and len(heard.records[CALM.id].steps) == 2


@pytest.mark.parametrize("name", REPLIES)
def test_one_reply_is_answered_in_words(heard, name):
    record = heard.records[hearing(name).id]
    *odd, last = record.steps
    assert [step.status for step in odd] == ["malformed"] * len(REPLIES[name].calls)
    assert record.end == "answered" and last.call.name == "answer_question"
    assert record.fault is None


def test_a_number_that_no_client_reads_is_a_reply_without_a_call(heard):
    (fault,) = seat_of(heard.records[hearing(UNREAD).id]).faults
    assert fault == "reply 1: can't be read: a number in it has too many digits"
    assert "That reply called no tool." in heard.told


def test_errors_and_replies_without_a_choice_are_faults_of_their_episode(tmp_path):
    heard = evaluated(tmp_path, UNANSWERED)
    error, none = (hearing(name).id for name in UNANSWERED)
    assert heard.values == {error: "missing", none: "missing", CALM.id: "C"}
    fault = heard.records[error].fault or ""
    assert "gave no reply 1" in fault and "400" in fault and "no ? such thing" in fault, fault
    assert heard.records[none].end == "fault"


def test_a_server_that_sent_no_choice_is_asked_again_when_the_run_goes_on(tmp_path):
    """Though what it sent was kept, as every reply is."""
    suite, sent = replace(demo(2), tasks=(CALM,)), [0]

    def say(number: int, body: dict[str, Any]) -> Reply:
        sent[0] += 1
        return Reply(choices=0) if sent[0] <= 2 else Reply(calls=(answer(CALM.answer),))

    with serving(say, keep=False) as server:
        for value in ("missing", "missing", "C"):
            log = run_in(plan(tmp_path, "agentic", suite), server.url, max_retries=0)
            assert values_of(log) == {CALM.id: value}
    assert sent == [3] and kept(tmp_path)[CALM.id].end == "answered"


PROTOCOLS: dict[str, tuple[str, dict[str, Any]]] = {
    "openai/gpt-5.4": ("/v1", {"responses_api": True}),
    "anthropic/claude-opus-4-7": ("", {"streaming": False}),
    "google/gemini-3.1-pro-preview": ("", {}),
}
DEEPER = "deeper"
IN_ALL = {
    **{it: REPLIES[it] for it in ("half a pair as a choice", "half a pair in words")},
    DEEPER: Reply(calls=(("push", '{"a":' * 500 + "1" + "}" * 500),)),
}


@pytest.fixture(scope="module", params=PROTOCOLS)
def other(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory):
    """Records of an evaluation in another protocol, by the reply that each heard."""
    base, arguments = PROTOCOLS[request.param]
    tasks = {name: hearing(name) for name in IN_ALL}
    begun, out = set[str](), tmp_path_factory.mktemp("other")

    def say(number: int, body: dict[str, Any]) -> Reply:
        if "push" not in json.dumps(body.get("tools", "")):
            return Reply("hello, world")
        (name,) = (it for it in IN_ALL if f"Hear {it!r}!" in json.dumps(body))
        if name in begun:
            return Reply(calls=(answer("E"),))
        begun.add(name)
        return IN_ALL[name]

    with serving(say) as server:
        url = server.url.removesuffix("/v1") + base
        model = get_model(request.param, base_url=url, api_key="none", memoize=False, **arguments)
        asked = plan(out, "agentic", replace(demo(1), tasks=(*tasks.values(),)))
        runner = ModelRunner(asked, PaintedPlace)
        (log,) = evaluate(
            harness_task(asked, runner), model=model, display="none", max_retries=0,
            log_dir=str(out / "logs"), max_tokens=1000, max_samples=asked.workers,
        )  # fmt: skip
        runner.close()
    assert log.status == "success"
    records = kept(out)
    assert set(records) == {task.id for task in tasks.values()}
    return {name: records[task.id] for name, task in tasks.items()}


@pytest.mark.parametrize("which", IN_ALL)
def test_other_protocols(other, which):
    record = other[which]
    calls = [reply.calls for reply in seat_of(record).replies]
    assert record.end == "answered" and len(calls) == 2, record.fault
    # Where arguments are no text on the wire, the client can't read what is nested too deep.
    assert [step.status for step in record.steps] == ["malformed", "done"][1 - calls[0] :]
    assert calls[0] == 1 or which == DEEPER
