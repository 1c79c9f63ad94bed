"""What the clients of other protocols send: pictures arrive, in order, after each call."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import Any

import pytest
from inspect_ai import eval as evaluate
from inspect_ai.model import get_model

from bench.painted import PaintedPlace, demo, plan
from bench.sitting_in import FIND, GRASP, LOOK, answer, kept
from model_server import Reply, serving
from probe.bench.harness import harness_task
from probe.bench.seating import Seating

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)
(TASK,) = SUITE.tasks
CALLS = (LOOK, FIND, GRASP, answer("E"))
JPEG = b"\xff\xd8\xff"


class Moves:
    """Goes by how often it was asked; other questions (a provider's probing) get a word."""

    def __init__(self) -> None:
        self.bodies: list[dict[str, Any]] = []

    def __call__(self, number: int, body: dict[str, Any]) -> Reply:
        if TASK.question[:30] not in json.dumps(body, ensure_ascii=False):
            return Reply("hello, world")
        self.bodies.append(body)
        return Reply(calls=(CALLS[len(self.bodies) - 1],))


def leaves(value: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], str]]:
    """All texts of a body with their places, in order."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from leaves(inner, (*path, key))
    elif isinstance(value, list):
        for number, inner in enumerate(value):
            yield from leaves(inner, (*path, str(number)))
    elif isinstance(value, str):
        yield path, value


def is_picture(text: str) -> bool:
    data = text.partition("base64,")[2] or text
    try:
        return base64.urlsafe_b64decode(
            data[:400].ljust(-(-len(data[:400]) // 4) * 4, "=")
        ).startswith(JPEG)
    except ValueError:
        return False


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
        seating = Seating(plan(tmp_path, "agentic", SUITE), PaintedPlace)
        evaluate(
            harness_task(seating._plan, seating), model=model, display="none",
            log_dir=str(tmp_path / "logs"), max_tokens=1000,
        )  # fmt: skip
        seating.close()
    record = kept(tmp_path)[TASK.id]
    assert [step.call.name for step in record.steps] == [call[0] for call in CALLS], record.fault
    assert len(script.bodies) == 4
    for asked, body in enumerate(script.bodies):
        found = [(path, is_picture(text)) for path, text in leaves(body[turns])]
        places = [path[0] for path, picture in found if picture]
        # One with the question, and one for each call so far; never two in one turn of the talk.
        assert len(places) == asked + 1
        assert places == sorted(places, key=int) and len(set(places)) == len(places)
    tools = json.dumps(script.bodies[0].get("tools"))
    assert all(f'"{call[0]}"' in tools for call in CALLS)
