"""The environment's methods: what trainers find, and what they are told before an episode."""

from __future__ import annotations

import inspect
import re

import pytest

from interfaces.training.painted_tables import TASKS, painted_tables
from probe.errors import BadData, UnknownName
from probe.interfaces.training.environment import NoEpisode, ProbeEnv
from probe.interfaces.training.permission import NotForTraining
from probe.interfaces.training.thousandths import ProbeEnvThousandths
from probe.transcripts.tools import tools_for
from run_folders import DEMO


def described(doc: str) -> tuple[str, dict[str, str]]:
    """A docstring's description and arguments, as one line each."""
    words, _, arguments = doc.partition("Args:")
    lines = re.findall(r"^\s+(\w+): (.*)$", arguments, re.MULTILINE)
    return " ".join(words.split()), dict(lines)


def test_its_public_methods_are_the_tools_and_what_trainers_call():
    public = {
        name for name, _ in inspect.getmembers(ProbeEnv, inspect.isfunction) if name[0] != "_"
    }
    tools = {tool.name for tool in tools_for("pixels", setting="text-only")}
    assert public == tools | {"reset", "get_reward"}


@pytest.mark.parametrize(
    ("env", "tool"),
    [(ProbeEnv, tool) for tool in tools_for("pixels", setting="text-only")]
    + [(ProbeEnvThousandths, tool) for tool in tools_for("0-1000", setting="text-only")],
    ids=lambda it: it.__name__ if isinstance(it, type) else it.name,
)
def test_its_docstrings_are_what_an_evaluation_says_of_the_tools(env, tool):
    method = getattr(env, tool.name)
    words, arguments = described(inspect.getdoc(method) or "")
    parts = tool.parameters.get("properties", {})
    assert words == tool.description
    assert arguments == {name: part["description"] for name, part in parts.items()}
    parameters = list(inspect.signature(method).parameters.values())[1:]
    assert [it.name for it in parameters] == list(parts)
    needed = [it.name for it in parameters if it.default is inspect.Parameter.empty]
    assert needed == list(tool.parameters.get("required", []))


def test_rows_hold_the_first_messages_of_an_evaluation(tmp_path):
    row = painted_tables(tmp_path).rows()[0]
    system, user = row["prompt"]
    assert row["task"] == TASKS[0].id
    assert system["role"] == "system" and "You see no picture" in system["content"]
    assert user["role"] == "user" and user["content"].startswith(TASKS[0].question)


@pytest.mark.parametrize(("env", "points"), [(ProbeEnv, "0-1000"), (ProbeEnvThousandths, "pixels")])
def test_places_are_counted_as_the_tables_do(tmp_path, env, points):
    with pytest.raises(BadData, match=f'count places in {points}, .*is for points="pixels"'):
        env(painted_tables(tmp_path, points=points))


def test_without_an_episode_nothing_is_done(tmp_path):
    env = ProbeEnv(painted_tables(tmp_path))
    with pytest.raises(NoEpisode, match="Call reset"):
        env.perceive_scene()
    with pytest.raises(NoEpisode, match="Call reset"):
        env.get_reward()
    with pytest.raises(UnknownName, match="task called 'count-1'"):
        env.reset(task="count-1")


def test_tasks_of_evaluation_need_to_be_asked_for(tmp_path):
    with pytest.raises(NotForTraining, match="say evaluation=True"):
        painted_tables(tmp_path, suite=DEMO)
    assert len(painted_tables(tmp_path, suite=DEMO, evaluation=True).rows()) == len(DEMO)
