"""One seat at a table, in the form that OpenEnv's server takes."""

from __future__ import annotations

import time
from collections.abc import Sequence
from itertools import count
from typing import Any
from uuid import uuid4

from openenv.core.env_server.interfaces import Environment

import probe
from probe.bench.process_pool import EpisodeProcessLost
from probe.interfaces.training.tables import TooFewTables, TrainingTables
from probe_openenv.models import EpisodeState, TableReply, ToolCall

LEAVING = 120.0
"""Seconds within which a connection that has ended gives its table back."""


class Seats:
    """What all connections share: the tables, and whose turn it is.

    Args:
        tables: See probe.training_tables.
    """

    def __init__(self, tables: TrainingTables) -> None:
        self.tables, self.tools = tables, tables.tools
        self._rows: Sequence[dict[str, Any]] = tables.rows()
        self._next = count()

    def row(self, task: str | None, seed: int | None) -> dict[str, Any]:
        """A task's row: that of an id, or the one that a seed or else the turn leads to.

        Raises:
            UnknownName: There is no such task.
        """
        if task is not None:
            return self.tables.row(task)
        return self._rows[(next(self._next) if seed is None else seed) % len(self._rows)]

    def __call__(self) -> ProbeEnvironment:
        """An environment for a connection."""
        return ProbeEnvironment(self)


class ProbeEnvironment(Environment[ToolCall, TableReply, EpisodeState]):
    """A seat at a table for one connection, for episode after episode."""

    SUPPORTS_CONCURRENT_SESSIONS = True

    def __init__(self, seats: Seats) -> None:
        super().__init__()
        self._seats = seats
        self._env = probe.ProbeEnv(seats.tables)
        self._state = EpisodeState()

    def reset(
        self,
        seed: int | None = None,
        episode_id: str | None = None,
        task: str | None = None,
        **_: Any,
    ) -> TableReply:
        """Begin an episode: what a model is told first, and its tools."""
        row = self._seats.row(task, seed)
        self._sit(row)
        self._state = EpisodeState(episode_id=episode_id or uuid4().hex, task=row["task"])
        return TableReply(messages=row["prompt"], tools=self._seats.tools)

    def step(self, action: ToolCall, timeout_s: float | None = None, **_: Any) -> TableReply:
        """Call a tool; once the episode is over, the reply has the reward."""
        self._state.step_count += 1
        try:
            came = self._env(action.tool, action.arguments)
        except EpisodeProcessLost as lost:
            return TableReply(text=str(lost), done=True, reward=self._env.get_reward())
        reward = self._env.get_reward() if came.ended else None
        return TableReply(text=came.text, done=came.ended, reward=reward)

    def _sit(self, row: dict[str, Any]) -> None:
        """Begin; whoever was the last to go may still be at a table that was being set."""
        end = time.monotonic() + LEAVING
        while True:
            try:
                self._env.reset(**row)
            except TooFewTables:
                if time.monotonic() > end:
                    raise
                time.sleep(0.1)
            else:
                return

    @property
    def state(self) -> EpisodeState:
        """Where the episode is."""
        return self._state

    def close(self) -> None:
        """Give the seat to others; an episode under way is lost."""
        self._env.__exit__()
