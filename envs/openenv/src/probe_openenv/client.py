"""The client: one seat at a table for each connection."""

from __future__ import annotations

from typing import Any

from openenv.core import EnvClient
from openenv.core.client_types import StepResult

from probe_openenv.models import EpisodeState, TableReply, ToolCall


class ProbeTable(EnvClient[ToolCall, TableReply, EpisodeState]):
    """A seat at a table of a server; each connection has its own.

    `ProbeTable(base_url="http://localhost:8000").sync()` is the form without `await`.
    `reset(task=...)` or `reset(seed=...)` chooses the task; without either, tasks come in turn.
    """

    def _step_payload(self, action: ToolCall) -> dict[str, Any]:
        return action.model_dump(exclude={"metadata"})

    def _parse_result(self, payload: dict[str, Any]) -> StepResult[TableReply]:
        told = {"done": payload.get("done", False), "reward": payload.get("reward")}
        reply = TableReply(**{**payload.get("observation", {}), **told})
        return StepResult(observation=reply, reward=reply.reward, done=reply.done)

    def _parse_state(self, payload: dict[str, Any]) -> EpisodeState:
        return EpisodeState(**payload)
