"""What the clients of other protocols send: pictures arrive, in order, after each call."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import Any

import pytest
from inspect_ai import eval as evaluate
from inspect_ai.model import get_model

from bench.painted import PaintedPlace, demo, plan, shown
from bench.sitting_in import FIND, GRASP, answer, kept
from model_server import Reply, serving
from probe.bench.harness import harness_task
from probe.bench.model_runner import ModelRunner
from probe.episodes.turns import Call

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)
(TASK,) = SUITE.tasks
MUG = ("find_object", '{"description": "red mug"}')
CALLS = (FIND, GRASP, MUG, answer("E"))
"""Each but the last shows something else."""

JPEG = b"\xff\xd8\xff"
RESULTS = ("function_call_output", "tool_result")
IDS = ("tool_call_id", "call_id", "tool_use_id")
"""Where protocols name the call that a result is of."""


class Moves:
    """Goes by how often it was asked; other questions (a provider's probing) get a word."""

    def __init__(self) -> None:
        self.bodies: list[dict[str, Any]] = []
        self.ids: list[str] = []

    def __call__(self, number: int, body: dict[str, Any]) -> Reply:
        if TASK.question[:30] not in json.dumps(body, ensure_ascii=False):
            return Reply("hello, world")
        self.bodies.append(body)
        self.ids.append(f"r{number}c0")
        return Reply(calls=(CALLS[len(self.bodies) - 1],))


def told(value: Any) -> Iterator[str | bytes]:
    """Whose result begins (a call's id; Google's protocol has its name), and pictures, in order."""
    if isinstance(value, dict):
        if value.get("role") == "tool" or value.get("type") in RESULTS:
            yield next(str(value[key]) for key in IDS if key in value)
        for key, inner in value.items():
            if key == "functionResponse":
                yield inner["name"]
            yield from told(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from told(inner)
    elif isinstance(value, str) and (picture := picture_of(value)):
        yield picture


def picture_of(text: str) -> bytes:
    """The JPEG file that a text is; empty if it is none."""
    data = text.partition("base64,")[2] or text
    try:
        found = base64.b64decode(data.replace("-", "+").replace("_", "/"), validate=True)
    except ValueError:
        return b""
    return found if found.startswith(JPEG) else b""


@pytest.mark.parametrize(
    ("name", "base", "arguments", "turns"),
    [
        ("openai-api/local/m", "/v1", {}, "messages"),
        ("openai/gpt-5.4", "/v1", {"responses_api": True}, "input"),
        ("anthropic/claude-opus-4-7", "", {"streaming": False}, "messages"),
        ("google/gemini-3.1-pro-preview", "", {}, "contents"),
    ],
)
def test_pictures_arrive_after_each_call(tmp_path, name, base, arguments, turns):
    script = Moves()
    with serving(script) as server:
        url = server.url.removesuffix("/v1") + base
        model = get_model(name, base_url=url, api_key="none", memoize=False, **arguments)
        runner = ModelRunner(plan(tmp_path, "agentic", SUITE), PaintedPlace)
        evaluate(
            harness_task(runner._plan, runner), model=model, display="none",
            log_dir=str(tmp_path / "logs"), max_tokens=1000,
        )  # fmt: skip
        runner.close()
    record = kept(tmp_path)[TASK.id]
    assert [step.call.name for step in record.steps] == [call[0] for call in CALLS], record.fault
    assert len(script.bodies) == 4
    first, later = shown(runner._plan, [Call.of(tool, json.loads(said)) for tool, said in CALLS])
    assert len({first, *later}) == len(CALLS) + 1
    ids = [tool for tool, _ in CALLS] if turns == "contents" else script.ids
    for asked, body in enumerate(script.bodies):
        # Of each call so far its result, then the picture that came of it.
        pairs = zip(ids[:asked], later[:asked], strict=True)
        assert list(told(body[turns])) == [first, *(part for pair in pairs for part in pair)]
    tools = json.dumps(script.bodies[0].get("tools"))
    assert all(f'"{call[0]}"' in tools for call in CALLS)
