"""Our messages, tools and calls in the harness's words, and back."""

from __future__ import annotations

import base64
import json

from inspect_ai.model import (
    ChatMessage,
    ChatMessageSystem,
    ChatMessageTool,
    ChatMessageUser,
    Content,
    ContentImage,
    ContentText,
)
from inspect_ai.tool import ToolCall, ToolInfo, ToolParams

from probe.chat.coordinates import told
from probe.chat.messages import Message
from probe.chat.tools import expressible, tools_for
from probe.episodes.seat import Points
from probe.episodes.turns import Call
from probe.runs.table_talk import Told
from probe.toolshed.tools import ToolSchema

_BEFORE, _AFTER = "tool call arguments:\n\n", "\n\nError details:"
"""Around the arguments in what the harness says of a call that it can't read."""


def tool_infos(points: Points) -> list[ToolInfo]:
    """The five tools; names and texts are the toolshed's, byte for byte."""
    return [_info(tool) for tool in tools_for(points)]


def first_messages(told_first: tuple[Message, Message]) -> list[ChatMessage]:
    """The rules, and the question with its pictures."""
    rules, question = told_first
    content: list[Content] = [ContentText(text=question.text)]
    content += map(_image, question.pictures)
    first: list[ChatMessage] = [ChatMessageSystem(content=rules.text)]
    return [*first, ChatMessageUser(content=content)]


def result_message(call: ToolCall, came: Told, points: Points) -> ChatMessageTool:
    """What came of a call; a picture stands after its words."""
    text = ContentText(text=told(came.text, points))
    content: list[Content] = [text] if came.picture is None else [text, _image(came.picture)]
    return ChatMessageTool(content=content, tool_call_id=call.id, function=call.function)


def call_of(call: ToolCall, words: str) -> Call:
    """A call as the record keeps it; arguments that are no JSON object as they were sent."""
    if call.parse_error is None:
        return Call.of(call.function, call.arguments, words)
    _, found, rest = call.parse_error.partition(_BEFORE)
    sent = rest.rpartition(_AFTER)[0] if found else call.parse_error
    return Call(call.function, sent if _unreadable(sent) else json.dumps(sent), words)


def data_uri(picture: bytes) -> str:
    """A JPEG file as an address."""
    return "data:image/jpeg;base64," + base64.b64encode(picture).decode()


def _unreadable(text: str) -> bool:
    """It mustn't come to be a valid call after all."""
    try:
        return not isinstance(json.loads(text), dict)
    except (ValueError, RecursionError):
        return True


def _image(picture: object) -> ContentImage:
    assert isinstance(picture, bytes)
    return ContentImage(image=data_uri(picture))


def _info(tool: ToolSchema) -> ToolInfo:
    parameters = ToolParams.model_validate(expressible(tool.parameters))
    return ToolInfo(name=tool.name, description=tool.description, parameters=parameters)
