"""Runs one episode: the agent calls, the tools answer, the record grows. Knows no engine."""

from __future__ import annotations

import time
from typing import Protocol

from probe.episodes.record import End, EpisodeRecord, Seconds, Step, Table
from probe.episodes.turns import Agent, Call, Question, Turn
from probe.errors import ProbeError
from probe.scene.scene import Scene
from probe.toolshed.toolshed import Toolshed
from probe.types import Array


class Witness(Protocol):
    """Sees the table as it really is, for the record; no tool and no agent gets to it."""

    def snapshot(self) -> Scene:
        """The table as it really is."""
        ...

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (n,)."""
        ...


def run_episode(
    task: str,
    question: Question,
    agent: Agent,
    toolshed: Toolshed,
    witness: Witness,
    *,
    agent_name: str,
    run: int = 0,
) -> EpisodeRecord:
    """Let an agent work on a question until it answers, stops, or its turns are over.

    A failure of ours (a ProbeError that a tool raises) ends the episode as "fault" and is
    recorded; it is no answer and mustn't be counted as a wrong one.

    Args:
        task: Name of the task, for the record.
        question: What is asked.
        agent: Sees the question and the tools' results, nothing else.
        toolshed: Fresh, over the table that the witness watches.
        witness: Tells the record where things are.
        agent_name: For the record.
        run: Number of the run, for the record.
    """
    start, steps, history = _table(witness), list[Step](), list[Turn]()
    thinking, working = list[float](), list[float]()
    fault: str | None = None
    stopped = False
    while not toolshed.ended:
        began = time.perf_counter()
        call = agent.act(question, tuple(history))
        if call is None:
            stopped = True
            break
        call = _storable(call)
        asked = time.perf_counter()
        try:
            result = toolshed.call(call.name, call.values)
        except ProbeError as error:
            fault = f"{type(error).__name__}: {error}"
            break
        thinking.append(asked - began)
        working.append(time.perf_counter() - asked)
        history.append(Turn(call, result))
        steps.append(Step(call, result.status, result.text, result.point_px, _table(witness)))
    end = _end(toolshed, stopped=stopped, fault=fault)
    seconds = Seconds(tuple(thinking), tuple(working))
    return EpisodeRecord(
        task, agent_name, run, question, start, tuple(steps), toolshed.answer, end, fault, seconds
    )


def _table(witness: Witness) -> Table:
    return Table(witness.snapshot(), tuple(float(angle) for angle in witness.joints()))


def _storable(call: Call) -> Call:
    """The call as UTF-8 can hold it; models may send halves of surrogate pairs."""
    parts = (call.name, call.arguments, call.words)
    return Call(*(part.encode("utf-8", "replace").decode() for part in parts))


def _end(toolshed: Toolshed, *, stopped: bool, fault: str | None) -> End:
    if fault is not None:
        return "fault"
    if toolshed.answer is not None:
        return "answered"
    return "stopped" if stopped else "out_of_turns"
