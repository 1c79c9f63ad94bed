"""An agent that acts in a process of its own, and what makes one for each episode."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.agents.outside.process import AgentFailed, AgentProcess
from probe.agents.outside.protocol import (
    AskedDocument,
    Confined,
    Opening,
    Ready,
    Reply,
    Step,
    ToldDocument,
)
from probe.agents.outside.readable import reach
from probe.agents.outside.sandbox import AgentFile, Sandbox
from probe.episodes.turns import Call, Question, Turn
from probe.errors import BadData, OutputFailed

_GB = 10**9
_WORDS = 1000
"""Characters of somebody else's words that are kept of what went wrong."""


class Outsider:
    """Asks an agent in a process of its own; an Agent. Close it to end that process.

    Whatever goes wrong over there ends the episode, as if the agent had stopped: it is its doing.

    Args:
        invitation: Which agent, and what it is allowed.
        task: Name of the task, as a heading of what the agent prints; the agent isn't told.
        run: Number of the run: the agent's seed follows from it and from what is asked.

    Attributes:
        pictures: Whether it looks at pictures.
        fault: What went wrong, in words; None if nothing has.
    """

    def __init__(self, invitation: Invitation, task: str, run: int) -> None:
        self.pictures = invitation.pictures
        self.fault: str | None = None
        self._invitation = invitation
        self._task = task
        self._run = run
        self._process: AgentProcess | None = None
        self._told = 0

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call; None if the agent stops, or fails.

        Raises:
            WorkerDied: A process for it couldn't be set up.
        """
        try:
            reply = self._asked(question, history)
        except AgentFailed as failure:
            return self._failed(str(failure))
        if reply.failed is not None:
            return self._failed(reply.failed)
        if reply.call is None:
            return None
        return Call(reply.call.name, reply.call.arguments, reply.call.words)

    def close(self) -> None:
        """End the process, and add what the agent printed to the log.

        Raises:
            OutputFailed: The log can't be written.
        """
        if self._process is None:
            return
        printed, self._process = self._process.close(), None
        if printed and self._invitation.log is not None:
            words = printable(printed.decode("utf-8", "replace"))
            add_prints(self._invitation.log, f"{self._task}, run {self._run}", words)

    def _failed(self, words: str) -> None:
        self.fault = printable(words)[:_WORDS]

    def _asked(self, question: Question, history: Sequence[Turn]) -> Reply:
        asked = None
        if self._process is None:
            self._process = AgentProcess(self._invitation.opening(seed_of(question, self._run)))
            asked = AskedDocument.of(question)
        turns = tuple(ToldDocument.of(turn) for turn in history[self._told :])
        self._told = len(history)
        return self._process.ask(
            Step(question=asked, turns=turns), self._invitation.sandbox.seconds
        )


@dataclass(frozen=True)
class Invitation:
    """What makes an agent of a file for each episode; a value that workers can be sent.

    Attributes:
        file: Where it comes from.
        sandbox: What it is allowed.
        hidden: Files and folders that it must not read.
        pictures: Whether it looks at pictures.
        log: Where what it prints goes; None for nowhere.
    """

    file: AgentFile
    sandbox: Sandbox = Sandbox()
    hidden: tuple[Path, ...] = ()
    pictures: bool = False
    log: Path | None = None

    def opening(self, seed: int = 0) -> Opening:
        """What its process is told first."""
        files = self.sandbox.files
        found = reach(self.file.path, files, self.hidden)
        return Opening(
            file=str(self.file.path),
            name=self.file.name,
            seed=seed,
            memory=round(self.sandbox.memory_gb * _GB),
            network=self.sandbox.network,
            readable=found.whole,
            listable=found.names,
            modules=tuple(str(path.resolve()) for path in files if path.is_dir()),
        )


def seed_of(question: Question, run: int) -> int:
    """A seed for an agent: of what it is told anyway, so that it tells nothing of the task's."""
    asked = json.dumps([question.text, question.options, run])
    return int.from_bytes(hashlib.sha256(asked.encode("utf-8", "replace")).digest()[:8], "big")


def introduced(invitation: Invitation) -> tuple[Confined, Ready]:
    """Make the agent once: what its process is kept from, its name, and whether it sees.

    Raises:
        BadData: There is no agent in the file.
        WorkerDied: A process for it couldn't be set up.
    """
    try:
        process = AgentProcess(invitation.opening())
    except AgentFailed as failure:
        remedy = "See docs/agents.md"
        raise BadData(invitation.file.path, printable(str(failure))[:_WORDS], remedy) from failure
    process.close()
    return process.confined, process.ready


def add_prints(log: Path, heading: str, words: str) -> None:
    """Add what an agent printed in an episode; one write, so that workers don't mix theirs.

    Raises:
        OutputFailed: It can't be written.
    """
    text = f"== {heading} ==\n{words}{'' if words.endswith(chr(10)) else chr(10)}"
    try:
        with log.open("ab", buffering=0) as file:
            file.write(text.encode())
    except OSError as error:
        raise OutputFailed(log, error.strerror or str(error)) from error


def printable(text: str) -> str:
    """Somebody else's text without what a terminal would obey."""
    return "".join(sign if sign.isprintable() or sign in "\n\t" else "\ufffd" for sign in text)
