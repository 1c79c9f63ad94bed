"""One episode under way: a call in, a result out, the record so far. Knows no agent, no engine."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Protocol

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.noise import NO_NOISE, Noise
from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed
from probe.episodes.record import End, EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call, Question, Turn
from probe.errors import ProbeError
from probe.scene.scene import Scene
from probe.scene.viewpoint import Viewpoint
from probe.texts import writable
from probe.toolshed.refusals import EpisodeOver
from probe.toolshed.result import ToolResult
from probe.toolshed.toolshed import Toolshed
from probe.types import Array

FAILED = "Something failed that is not your doing; the episode has ended."
"""What an agent reads of a failure of ours; the record alone says what it was."""


class StateReader(Protocol):
    """Sees the table as it really is, for the record; no tool and no agent gets to it."""

    def snapshot(self) -> Scene:
        """The table as it really is."""
        ...

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (n,)."""
        ...


class Episode:
    """A question, the tools to answer it with, and all that has been done so far.

    Args:
        task: Name of the task, for the record.
        question: What is asked.
        toolshed: Fresh, over the table that the witness watches.
        state: Tells the record where things are.
        agent_name: For the record.
        run: Number of the run, for the record.
        noise: How far the hand errs, for the record.
        conditions: In what the episode differs from its task, for the record.
        viewpoint: From where and in which light the table is seen, for the record.
        perception: What the tools see with, for the record.
        photograph: Keeps a picture of a real table and gives its name; None in simulation, where
            poses are kept.
    """

    def __init__(
        self,
        task: str,
        question: Question,
        toolshed: Toolshed,
        state: StateReader,
        *,
        agent_name: str,
        run: int = 0,
        noise: Noise = NO_NOISE,
        conditions: Conditions = AS_FROZEN,
        viewpoint: Viewpoint | None = None,
        perception: PerceptionUsed = ORACLE_USED,
        photograph: Callable[[], str] | None = None,
    ) -> None:
        self._toolshed = toolshed
        self._state = state
        self._photograph = photograph
        start = _table(state)
        # Replaced whole after each step, so that it is true whenever it is looked at.
        self._record = EpisodeRecord(
            task,
            agent_name,
            run,
            question,
            start,
            (),
            None,
            "stopped",
            noise=noise,
            conditions=conditions,
            viewpoint=viewpoint or Viewpoint(),
            perception=perception,
            frames=(photograph(),) if photograph else (),
        )
        self._idle_since = time.perf_counter()

    @property
    def record(self) -> EpisodeRecord:
        """What has happened; it ends as "stopped" as long as another call may follow."""
        return self._record

    @property
    def ended(self) -> bool:
        """Whether further calls do nothing."""
        return self._record.end != "stopped"

    def step(self, call: Call) -> Turn:
        """Do one call; a ProbeError that a tool raises ends the episode as our fault.

        Returns:
            The call as it was recorded, and what came of it.
        """
        call = _storable(call)
        if self.ended:
            return Turn(call, ToolResult(str(EpisodeOver()), ended=True, status="refused"))
        asked = time.perf_counter()
        try:
            result = self._toolshed.call(call.name, call.values)
            working = time.perf_counter() - asked
            frames = (self._photograph(),) if self._photograph else ()
            table = _table(self._state)
        except ProbeError as error:
            return Turn(call, self.fail(error))
        self._add(Step(call, result.status, result.text, result.point_px, table), frames)
        self._add_seconds(asked - self._idle_since, working)
        self._idle_since = time.perf_counter()
        return Turn(call, result)

    def restart_clock(self) -> None:
        """Count the time to the next call from now on: only now is the question shown."""
        self._idle_since = time.perf_counter()

    def take_times(self, seconds: Seconds) -> None:
        """Put the times of an earlier record of the same calls in place of these."""
        self._record = replace(self._record, seconds=seconds)
        self.restart_clock()

    def fail(self, error: Exception) -> ToolResult:
        """End the episode as our fault, which is no answer and mustn't count as a wrong one."""
        fault = f"{type(error).__name__}: {error}"
        self._record = replace(self._record, end="fault", fault=fault)
        return ToolResult(FAILED, ended=True, status="refused")

    def _add(self, step: Step, frames: tuple[str, ...]) -> None:
        before = self._record
        self._record = replace(
            before,
            steps=(*before.steps, step),
            frames=(*before.frames, *frames),
            answer=self._toolshed.answer,
            end=_end(self._toolshed),
        )

    def _add_seconds(self, thinking: float, working: float) -> None:
        agent, tools = self._record.seconds.agent, self._record.seconds.tools
        seconds = Seconds((*agent, thinking), (*tools, working))
        self._record = replace(self._record, seconds=seconds)


def _table(state: StateReader) -> TableState:
    return TableState(state.snapshot(), tuple(float(angle) for angle in state.joints()))


def _storable(call: Call) -> Call:
    """The call as UTF-8 can hold it; models may send halves of surrogate pairs."""
    return Call(writable(call.name), writable(call.arguments), writable(call.words))


def _end(toolshed: Toolshed) -> End:
    if toolshed.answer is not None:
        return "answered"
    return "out_of_turns" if toolshed.ended else "stopped"
