"""An agent of ours behind the wire: all it knows is what stands in the request."""

from __future__ import annotations

import json
from typing import Any

from model_server import Reply
from probe.api.agents import make_agent
from probe.assets.library import Library
from probe.episodes.grading import question_of
from probe.episodes.turns import Agent, Call, Turn
from probe.render.renderer import Renderer
from probe.tasks.suite import Suite
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult
from probe.transcripts.messages import PICTURE_FOLLOWS

GIVES_UP = "I give up."


def agent_in_run_0(name: str, task: Task, run: int, library: Library, renderer: Renderer) -> Agent:
    """As make_agent, but it doesn't know which run this is: a request doesn't say so either."""
    return make_agent(name, task, 0, library, renderer)


def task_of(body: dict[str, Any], suite: Suite) -> Task:
    """Which task a request is about: its question and its options stand in it."""
    text = json.dumps(body["messages"][:2], ensure_ascii=False)
    found = [
        task for task in suite.tasks if json.dumps(_asked(task), ensure_ascii=False)[1:-1] in text
    ]
    if len(found) != 1:
        raise LookupError(f"{len(found)} tasks ask this")
    return found[0]


def history_of(body: dict[str, Any]) -> list[Turn]:
    """All calls so far with the texts that came of them."""
    calls: dict[str, Call] = {}
    turns: list[Turn] = []
    for message in body["messages"]:
        for call in message.get("tool_calls") or []:
            said = call["function"]
            calls[call["id"]] = Call(said["name"], said["arguments"], message["content"] or "")
        if message["role"] == "tool":
            text = _words(message["content"]).removesuffix("\n" + PICTURE_FOLLOWS)
            turns.append(Turn(calls[message["tool_call_id"]], ToolResult(text)))
    return turns


class Policy:
    """Plays an agent that is begun anew for each request and told what came of its own calls.

    Calls that a failing server put into its mouth are passed over.
    """

    def __init__(self, name: str, suite: Suite, library: Library, renderer: Renderer) -> None:
        self._name, self._suite = name, suite
        self._library, self._renderer = library, renderer

    def __call__(self, number: int, body: dict[str, Any]) -> Reply:
        task = task_of(body, self._suite)
        agent = agent_in_run_0(self._name, task, 0, self._library, self._renderer)
        question, mine = question_of(task), list[Turn]()
        call = agent.act(question, mine)
        for turn in history_of(body):
            if call and (turn.call.name, turn.call.values) == (call.name, call.values):
                mine.append(turn)
                call = agent.act(question, mine)
        if call is None:
            return Reply(GIVES_UP)
        return Reply(call.words or None, calls=((call.name, call.arguments),))


def _asked(task: Task) -> str:
    return "\n".join([task.question, *(f"{it.letter}: {it.text}" for it in task.options)])


def _words(content: Any) -> str:
    if isinstance(content, str):
        return content
    return "\n".join(part["text"] for part in content if part["type"] == "text")
