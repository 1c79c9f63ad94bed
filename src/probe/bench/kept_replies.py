"""Asks a model with the harness's cache, which keeps replies that hold nothing, too."""

from __future__ import annotations

from collections.abc import Sequence

from inspect_ai.event import Event, ModelEvent
from inspect_ai.log import transcript
from inspect_ai.model import CachePolicy, ChatMessage, GenerateConfig, Model, ModelOutput
from inspect_ai.tool import ToolInfo


async def generated(
    model: Model,
    messages: Sequence[ChatMessage],
    cache: CachePolicy,
    tools: Sequence[ToolInfo] = (),
) -> ModelOutput:
    """A reply; one without a choice that was kept is no answer, so the server is asked anew.

    Args:
        model: Who is asked.
        messages: So far.
        cache: Where replies are kept.
        tools: What it may call, one at a time.
    """
    config = GenerateConfig(parallel_tool_calls=False) if tools else GenerateConfig()
    policy, anew, seen = cache, 0, len(transcript().events)
    while True:
        output = await model.generate(list(messages), tools=tools, config=config, cache=policy)
        if not output.empty or not _kept_earlier(transcript().events[seen:]):
            return output
        anew, seen = anew + 1, len(transcript().events)
        policy = cache.model_copy(update={"scopes": cache.scopes | {"anew": str(anew)}})


def _kept_earlier(events: Sequence[Event]) -> bool:
    """Whether what a model is said to have replied came from the cache."""
    return any(isinstance(event, ModelEvent) and event.cache == "read" for event in events)
