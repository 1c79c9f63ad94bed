"""What passes between a client and the environment."""

from __future__ import annotations

from typing import Any

from openenv.core.env_server.types import Action, Observation, State
from pydantic import Field


class ToolCall(Action):
    """A call of one of the five tools.

    A call that doesn't fit the tool costs a turn and is refused with the reason, as in an
    evaluation.
    """

    tool: str = Field(description="Name of the tool")
    arguments: dict[str, Any] = Field(default_factory=dict, description="By name")


class TableReply(Observation):
    """What the model is told: first messages and tools at the start, then a tool's reply.

    Its `reward` is the task's grade once `done`: 1 for a right answer, 0 for another or none. None
    where the episode was lost through no fault of the model: leave such an episode out.
    """

    text: str = Field(default="", description="A tool's reply")
    messages: list[dict[str, str]] = Field(
        default_factory=list[dict[str, str]], description="At the start: what the model is told"
    )
    tools: list[dict[str, Any]] = Field(
        default_factory=list[dict[str, Any]],
        description="At the start: the tools, as servers of OpenAI's protocol get them",
    )


class EpisodeState(State):
    """Where an episode is."""

    task: str | None = Field(default=None, description="Id of the task")
