"""Who acts in `probe run` without a model: an agent of ours by its name, or one of a file."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, replace
from pathlib import Path

from probe.agents.external.external_agent import ExternalAgent
from probe.agents.external.factory import FileAgentFactory, introduced
from probe.agents.external.protocol import Confinement
from probe.agents.external.sandbox import AgentFile, Sandbox
from probe.api.agents import SETTINGS, make_agent
from probe.assets.library import Library
from probe.cli.installed_agents import file_of, installed_agents
from probe.cli.screen import say
from probe.episodes.turns import Agent
from probe.errors import BadData, UnknownName
from probe.render.renderer import Renderer
from probe.runs.work import AgentOf
from probe.tasks.task import Task

PRINTS = "agent.log"
"""File in the folder of records that holds what an agent of a file printed."""

_OURS: Collection[str] = SETTINGS.keys()
_YOURS = "Your own is FILE.py:ClassName."
_NAME = re.compile(r"[A-Za-z0-9._-]{1,64}")


@dataclass(frozen=True)
class FileAgents:
    """Makes an agent of a file for each episode; see probe.runs.work.AgentOf."""

    invitation: FileAgentFactory

    def __call__(
        self, name: str, task: Task, run: int, library: Library, renderer: Renderer
    ) -> Agent:
        """A fresh one; of the task it gets what the question says, when it is asked."""
        return ExternalAgent(self.invitation, task.id, run)


def who_acts(
    agent: str, name: str | None, sandbox: Sandbox, suite: str, out: Path
) -> tuple[str, AgentOf]:
    """Name of who acts, for the records, and what makes it.

    Args:
        agent: A name of ours, "FILE.py", "FILE.py:Name", or an installed package's name for one.
        name: What an agent of a file is to be called; by default as its class, or as its package
            calls it.
        sandbox: What such an agent is allowed.
        suite: What is run: its file, if it is one, is kept from the agent.
        out: Folder for the records, which is kept from it as well.

    Raises:
        UnknownName: There is no such agent.
        BadData: There is none in the file, its name won't do, or an option does nothing.
    """
    installed = installed_agents()
    if ".py" not in agent and (agent in _OURS or agent not in installed):
        if agent not in _OURS:
            raise UnknownName("agent", agent, [*_OURS, *installed], _YOURS)
        if name is not None or sandbox != Sandbox():
            what = "--sandbox" if name is None else "--agent-name"
            raise BadData(what, "does nothing with an agent of ours", "Leave it out")
        return agent, make_agent
    sandbox.check()
    hidden = (Path(suite), out)
    offered = None if ".py" in agent else installed[agent]
    file = AgentFile.of(agent) if offered is None else file_of(offered)
    invitation = FileAgentFactory(file, sandbox, hidden, log=out / PRINTS)
    confined, ready = introduced(invitation)
    _tell(confined, sandbox, out)
    usual = ready.name if offered is None else offered.name
    called = _checked(usual if name is None else name)
    return called, FileAgents(replace(invitation, pictures=ready.pictures))


def _checked(name: str) -> str:
    if not _NAME.fullmatch(name):
        reason = "isn't made of 1 to 64 letters, digits, dots, dashes and underscores"
        raise BadData(repr(name), reason, "Say --agent-name NAME")
    if name in SETTINGS:
        raise BadData(name, "is the name of an agent of ours", "Say --agent-name NAME")
    return name


def _tell(confined: Confinement, sandbox: Sandbox, out: Path) -> None:
    """Say what the agent is kept from, and what not."""
    kept = confined.model_dump()
    if sandbox.network:
        del kept["network"]
    say(f"The agent runs in a process of its own, kept from {_list(kept, True)}.")
    if not all(kept.values()):
        say(f"This machine can't keep it from {_list(kept, False)}: see docs/reference/agents.md.")
    say(f"What it prints goes to {out / PRINTS}.")


def _list(kept: dict[str, bool], wanted: bool) -> str:
    words = {"files": "other files", "network": "the network", "processes": "other processes"}
    return ", ".join(words[name] for name, is_ in kept.items() if is_ == wanted) or "nothing"
