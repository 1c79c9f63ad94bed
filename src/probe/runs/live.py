"""Tables of a run as they are now, in a folder that a page looks into: a file for each worker."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pydantic

from probe.episodes.turns import Agent, Call, Question, Turn
from probe.files import write_bytes
from probe.toolshed.result import Status
from probe.transcripts.pictures import jpeg
from probe.types import Array


class LiveStep(pydantic.BaseModel):
    """A call, and what came of it; no status as long as the tool is at work."""

    tool: str
    arguments: str
    words: str
    status: Status | None = None
    text: str = ""


class LiveDocument(pydantic.BaseModel):
    """The episode at one table, with what its agent sees of it."""

    task: str
    run: int
    question: str
    options: tuple[tuple[str, str], ...]
    steps: list[LiveStep] = []
    pictures: int = 0


class LiveTable:
    """Writes down what happens at this process's table, in place of what was there before.

    Args:
        folder: Of the run's tables; the page reads `PID.json` and `PID.jpg` in it.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / f"{os.getpid()}.json"
        self._said = LiveDocument(task="", run=0, question="", options=())

    def begin(self, task: str, run: int, question: Question) -> None:
        """An agent is asked something.

        Raises:
            OutputFailed: It can't be written; this holds for all that follows, too.
        """
        self._said = LiveDocument(
            task=task, run=run, question=question.text, options=question.options
        )
        self._show(question.picture)

    def call(self, call: Call) -> None:
        """A tool begins."""
        step = LiveStep(tool=call.name, arguments=call.arguments, words=call.words)
        self._said.steps.append(step)
        self._write()

    def result(self, turn: Turn) -> None:
        """It has ended."""
        step = self._said.steps[-1]
        step.status, step.text = turn.result.status, turn.result.text
        self._show(turn.result.picture)

    def _show(self, picture: Array | None) -> None:
        if picture is not None:
            write_bytes(self._path.with_suffix(".jpg"), jpeg(picture))
            self._said.pictures += 1
        self._write()

    def _write(self) -> None:
        write_bytes(self._path, self._said.model_dump_json().encode())


class Watched:
    """An agent whose table is written down; decides as the agent does.

    Args:
        agent: Who decides.
        table: Where it is written down.
        task: Name of the task.
        run: Number of the run.
        pictures: Whether the agent looks at any; if not, it gets none, whatever the page shows.
    """

    def __init__(
        self, agent: Agent, table: LiveTable, task: str, run: int, *, pictures: bool
    ) -> None:
        self._agent = agent
        self._table = table
        self._of = task, run
        self._pictures = pictures

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The agent's next call."""
        if history:
            self._table.result(history[-1])
        else:
            self._table.begin(*self._of, question)
        if not self._pictures:
            question = replace(question, picture=None)
            history = tuple(map(_without_picture, history))
        call = self._agent.act(question, history)
        if call is not None:
            self._table.call(call)
        return call


def _without_picture(turn: Turn) -> Turn:
    return replace(turn, result=replace(turn.result, picture=None))
