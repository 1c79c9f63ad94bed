"""Calls with the arguments that a model sent: the harness mends them, and others aren't helped so.

Where arguments are a text on the wire, the harness makes the first parameter of what is no object,
and leaves out what follows one. Where they are an object (Anthropic, Google) there is nothing to
mend. Knows no tools.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, cast

from inspect_ai.model import ChatMessage, GenerateConfig, Model, ModelAPI, ModelCall, ModelOutput
from inspect_ai.tool import ToolCall, ToolChoice, ToolInfo

_BEFORE, _AFTER = "tool call arguments:\n\n", "\n\nError details:"
"""Around the arguments in what the harness says of a call that it can't read; so do we."""

_REPLIES = ("choices", "output", "outputs")
"""Where replies stand in OpenAI's chat, its responses, and xAI's protocol."""

_Generated = ModelOutput | tuple[ModelOutput | Exception, ModelCall]


def as_sent(model: Model) -> Model:
    """A model whose calls aren't mended; what the harness caches of it isn't either."""
    if not isinstance(model.api.generate, _AsSent):
        model.api.generate = _AsSent(model.api)
    return model


def unreadable_part(parse_error: str) -> str:
    """The arguments, of what is said of a call that can't be read."""
    _, found, rest = parse_error.partition(_BEFORE)
    return rest.rpartition(_AFTER)[0] if found else parse_error


def is_object(text: str) -> bool:
    """Whether arguments are a JSON object, as the tools want them."""
    try:
        return isinstance(json.loads(text), dict)
    except (ValueError, RecursionError):
        return False


class _AsSent:
    """Stands in for a provider's way to ask; undoes what was mended in its reply."""

    def __init__(self, api: ModelAPI) -> None:
        self._generate = api.generate

    async def __call__(
        self,
        input: list[ChatMessage],
        tools: list[ToolInfo],
        tool_choice: ToolChoice,
        config: GenerateConfig,
    ) -> _Generated:
        generated = await self._generate(input, tools, tool_choice, config)
        if isinstance(generated, tuple):
            output, wire = generated
            if isinstance(output, ModelOutput) and output.choices and wire.response:
                calls = output.message.tool_calls or []
                sent = list(_arguments([wire.response.get(place) for place in _REPLIES]))
                if len(sent) == len(calls):
                    for call, text in zip(calls, sent, strict=True):
                        _undo(call, text)
        return generated


def _undo(call: ToolCall, sent: str) -> None:
    if not sent.strip():
        call.arguments = {}  # servers write a call without arguments like this, too
    elif call.parse_error or not is_object(sent):
        call.arguments = {}
        call.parse_error = f"Error parsing {_BEFORE}{sent}{_AFTER} no JSON object"


def _arguments(reply: Any) -> Iterator[str]:
    """Arguments in a reply as it was on the wire, in order; of those protocols that have a text.

    In OpenAI's chat and xAI's protocol each is a function's; OpenAI's responses have items.
    """
    if isinstance(reply, list):
        for each in cast("list[Any]", reply):
            yield from _arguments(each)
    elif isinstance(reply, dict):
        part = cast("dict[str, Any]", reply)
        function = part.get("function", part if part.get("type") == "function_call" else None)
        if isinstance(function, dict) and "name" in function:
            yield str(cast("dict[str, Any]", function).get("arguments", ""))
            return
        for each in part.values():
            yield from _arguments(each)
