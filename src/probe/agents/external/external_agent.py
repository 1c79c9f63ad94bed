"""An agent that acts in a process of its own."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path

from probe.agents.external.factory import WORDS, FileAgentFactory, printable
from probe.agents.external.process import AgentFailed, AgentProcess
from probe.agents.external.protocol import AgentReply, AgentTurn, WireQuestion, WireResult
from probe.episodes.turns import Call, Question, Turn
from probe.errors import OutputFailed


class ExternalAgent:
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

    def __init__(self, invitation: FileAgentFactory, task: str, run: int) -> None:
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
        self.fault = printable(words)[:WORDS]

    def _asked(self, question: Question, history: Sequence[Turn]) -> AgentReply:
        asked = None
        if self._process is None:
            self._process = AgentProcess(self._invitation.opening(seed_of(question, self._run)))
            asked = WireQuestion.of(question)
        turns = tuple(WireResult.of(turn) for turn in history[self._told :])
        self._told = len(history)
        return self._process.ask(
            AgentTurn(question=asked, turns=turns), self._invitation.sandbox.seconds
        )


def seed_of(question: Question, run: int) -> int:
    """A seed for an agent: of what it is told anyway, so that it tells nothing of the task's."""
    asked = json.dumps([question.text, question.options, run])
    return int.from_bytes(hashlib.sha256(asked.encode("utf-8", "replace")).digest()[:8], "big")


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
        raise OutputFailed(log, error) from error
