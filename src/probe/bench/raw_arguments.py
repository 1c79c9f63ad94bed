"""Calls with the arguments that a model sent: the harness mends them, and others aren't helped so.

Where arguments are a text on the wire, the harness makes the first parameter of what is no object,
and leaves out what follows one. Where they are an object (Anthropic, Google) there is nothing to
mend. Knows no tools.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any, cast

from inspect_ai.model import (
    ChatCompletionChoice,
    ChatMessage,
    ChatMessageAssistant,
    GenerateConfig,
    Model,
    ModelAPI,
    ModelCall,
    ModelOutput,
)
from inspect_ai.tool import ToolCall, ToolChoice, ToolInfo

from probe.bench.reasoning_tags import bound_tags
from probe.bench.writable import made_writable, unreadable, writable_call, writable_output

_BEFORE, _AFTER = "tool call arguments:\n\n", "\n\nError details:"
"""Around the arguments in what the harness says of a call that it can't read; so do we."""

_REPLIES = ("choices", "output", "outputs")
"""Where replies stand in OpenAI's chat, its responses, and xAI's protocol."""

_EMPTY = ChatCompletionChoice(message=ChatMessageAssistant(content=""))

_Generated = ModelOutput | tuple[ModelOutput | Exception, ModelCall]


def as_sent(model: Model) -> Model:
    """A model whose calls aren't mended; what the harness caches of it isn't either.

    What can't be written down, or read, of its replies is put right before anybody sees it.
    """
    if not isinstance(model.api.generate, _AsSent):
        bound_tags(type(model.api).__module__)
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
    """Stands in for a provider's way to ask; replies are as the model sent them, and writable."""

    def __init__(self, api: ModelAPI) -> None:
        self._generate = api.generate

    async def __call__(
        self,
        input: list[ChatMessage],
        tools: list[ToolInfo],
        tool_choice: ToolChoice,
        config: GenerateConfig,
    ) -> _Generated:
        try:
            return _put_right(await self._generate(input, tools, tool_choice, config))
        except (ValueError, RecursionError) as error:
            reason = unreadable(error)
            if reason is None:
                made_writable(error)
                raise
            # The model's doing: it is told so, as of any reply without a call.
            return ModelOutput(choices=[_EMPTY.model_copy(deep=True)], error=reason)
        except Exception as error:  # whatever a provider's client may raise
            made_writable(error)
            raise


def _put_right(generated: _Generated) -> _Generated:
    if isinstance(generated, ModelOutput):
        return writable_output(generated)
    output, wire = generated
    if not isinstance(output, ModelOutput):
        made_writable(output)
        return output, writable_call(wire)
    if output.choices and wire.response:
        _undo_all(output, wire.response)
    return writable_output(output), writable_call(wire)


def _undo_all(output: ModelOutput, response: Mapping[str, Any]) -> None:
    calls = output.message.tool_calls or []
    sent = list(_arguments([response.get(place) for place in _REPLIES]))
    if len(sent) == len(calls):
        for call, text in zip(calls, sent, strict=True):
            _undo(call, text)


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
