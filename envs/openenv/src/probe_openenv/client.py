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

    Args:
        base_url: Where the server is.
        message_timeout_s: Seconds to wait for a reply. Setting a table takes seconds, and minutes
            where a machine does so for the first time. What comes later than that would be taken
            for the reply to the next call, so the connection is closed, and the episode lost with
            it: TimeoutError. The next reset connects anew.
        more: As EnvClient.
    """

    def __init__(self, base_url: str, *, message_timeout_s: float = 600.0, **more: Any) -> None:
        super().__init__(base_url, message_timeout_s=message_timeout_s, **more)

    async def _receive(self) -> dict[str, Any]:
        try:
            return await super()._receive()
        except TimeoutError as error:
            await self.disconnect()
            waited = f"The table said nothing for {self._message_timeout:g} seconds"
            remedy = "Its episode is lost; reset begins another. Raise message_timeout_s."
            raise TimeoutError(f"{waited}. {remedy}") from error

    def _step_payload(self, action: ToolCall) -> dict[str, Any]:
        return action.model_dump(exclude={"metadata"})

    def _parse_result(self, payload: dict[str, Any]) -> StepResult[TableReply]:
        told = {"done": payload.get("done", False), "reward": payload.get("reward")}
        reply = TableReply(**{**payload.get("observation", {}), **told})
        return StepResult(observation=reply, reward=reply.reward, done=reply.done)

    def _parse_state(self, payload: dict[str, Any]) -> EpisodeState:
        return EpisodeState(**payload)
