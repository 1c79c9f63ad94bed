"""Agents in files of their own, asked in processes of their own."""

from __future__ import annotations

import textwrap

import pytest

from probe.agents.external.external_agent import ExternalAgent
from probe.agents.external.factory import FileAgentFactory
from probe.agents.external.sandbox import AgentFile, Sandbox

HEAD = "from probe.episodes.turns import Call\n"


@pytest.fixture
def write(tmp_path):
    """Writes an agent's file; gives its path."""

    def written(code, name="agent.py"):
        path = tmp_path / "agents" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(HEAD + textwrap.dedent(code))
        return path

    return written


@pytest.fixture
def invite(write, tmp_path):
    """An invitation of an agent with this code."""

    def invited(code, name=None, sandbox=Sandbox(seconds=20)):  # noqa: B008 - a value
        return FileAgentFactory(AgentFile(write(code), name), sandbox, log=tmp_path / "agent.log")

    return invited


@pytest.fixture
def outsider(invite):
    """Makes an agent of some code; its process ends with the test."""
    made = []

    def make(code, name=None, run=0, **settings):
        made.append(ExternalAgent(invite(code, name, **settings), "task-1", run))
        return made[-1]

    yield make
    for each in made:
        each.close()
