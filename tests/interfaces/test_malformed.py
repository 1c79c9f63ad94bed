"""A thousand calls without sense, over the wire: each is answered, and nothing comes of them."""

import json

import pytest
from hypothesis import HealthCheck, given, settings

from interfaces import painted
from interfaces.clients import wired
from probe.episodes.files import read_records
from toolshed.test_malformed import CALLS

CALLS_MADE = 1000
LONG, SOME = 1_000_000, 20_000


@pytest.fixture(scope="module")
def out(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz")


@pytest.fixture(scope="module")
def wire(out):
    with wired(painted.__file__, out, 10 * CALLS_MADE) as it:
        yield it
        look = it.call("perceive_scene", {})["result"]
        assert not look.get("isError") and "white ball" in look["content"][0]["text"]
    assert it.process.returncode == 0
    (record,) = read_records(out / "records.jsonl")
    *junk, last = record.steps
    assert last.status == "done" and len(junk) >= it.called // 2
    assert {step.status for step in junk} <= {"malformed"}
    assert all(step.after == record.start for step in record.steps)
    assert record.end == "stopped" and record.answer is None and record.manipulations == 0


@settings(
    max_examples=CALLS_MADE,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(CALLS)
@pytest.mark.slow
def test_every_call_is_answered_and_none_does_anything(wire, call):
    name, arguments = sendable(call, wire.asked)
    reply = wire.call(name, arguments)
    assert ("result" in reply) != ("error" in reply)
    if isinstance(name, str) and isinstance(arguments, dict | None):
        assert reply["result"]["isError"]
        (content,) = reply["result"]["content"]
        assert content["type"] == "text" and 20 < len(content["text"]) < 700
    words = json.dumps(reply)
    assert len(words) < 2000 and "Traceback" not in words and "pydantic" not in words


@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"{",
        b"\xff\xfe\x00",
        b"[1, 2]",
        b"null",
        b'{"jsonrpc": "2.0"}',
        b'{"jsonrpc": "2.0", "id": {"a": 1}, "method": "tools/call"}',
        b'{"jsonrpc": "2.0", "id": 900001, "method": "tools/call"}',
        b'{"jsonrpc": "2.0", "id": 900002, "method": "sampling/createMessage", "params": {}}',
        b'{"jsonrpc": "2.0", "id": 900003, "method": "\\ud800", "params": []}',
        b'{"jsonrpc": "2.0", "id": 900004, "result": {}}',
        b'{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 7}}',
        b'{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": []}}',
        b'{"a":' * 100_000,
    ],
    ids=lambda line: line[:40].decode(errors="replace"),
)
def test_lines_that_are_no_requests_do_no_harm(wire, line):
    wire.send(line)
    assert "result" in wire.ask("ping")


def sendable(value, number):
    """A value that JSON can hold; every fiftieth long text stays as long as it is.

    A lone surrogate is no Unicode, so the protocol's own layer drops the whole line.
    """
    if isinstance(value, str):
        kept = value if len(value) < LONG or number % 50 == 0 else value[:SOME]
        return kept.encode("utf-8", "replace").decode()
    if isinstance(value, dict):
        return {sendable(k, number): sendable(v, number) for k, v in value.items()}
    return [sendable(v, number) for v in value] if isinstance(value, list | tuple) else value
