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

from probe.bench.raw_arguments import is_object, unreadable_part
from probe.episodes.participation import Points
from probe.episodes.turns import Call
from probe.toolshed.tools import ToolSchema
from probe.transcripts.messages import Message
from probe.transcripts.prompts import Setting
from probe.transcripts.tools import expressible, tools_for
from probe.types import USUAL_SCALE, PictureScale


def tool_infos(
    points: Points, scale: PictureScale = USUAL_SCALE, setting: Setting = "agentic"
) -> list[ToolInfo]:
    """The five tools; names and texts are those of tools_for(), byte for byte."""
    return [_info(tool) for tool in tools_for(points, scale, setting)]


def first_messages(told_first: tuple[Message, Message]) -> list[ChatMessage]:
    """The rules, and the question with its pictures."""
    rules, question = told_first
    content: list[Content] = [ContentText(text=question.text)]
    content += map(_image, question.pictures)
    first: list[ChatMessage] = [ChatMessageSystem(content=rules.text)]
    return [*first, ChatMessageUser(content=content)]


def result_message(call: ToolCall, words: str, picture: bytes | None) -> ChatMessageTool:
    """What came of a call; a picture stands after its words."""
    text = ContentText(text=words)
    content: list[Content] = [text] if picture is None else [text, _image(picture)]
    return ChatMessageTool(content=content, tool_call_id=call.id, function=call.function)


def call_of(call: ToolCall, words: str) -> Call:
    """A call as the record keeps it; arguments that are no JSON object as they were sent.

    One that the harness finds too deep to read mustn't come to be a valid call after all.
    """
    if call.parse_error is None:
        return Call.of(call.function, call.arguments, words)
    sent = unreadable_part(call.parse_error)
    return Call(call.function, json.dumps(sent) if is_object(sent) else sent, words)


def data_uri(picture: bytes) -> str:
    """A JPEG file as an address."""
    return "data:image/jpeg;base64," + base64.b64encode(picture).decode()


def _image(picture: object) -> ContentImage:
    assert isinstance(picture, bytes)
    return ContentImage(image=data_uri(picture))


def _info(tool: ToolSchema) -> ToolInfo:
    parameters = ToolParams.model_validate(expressible(tool.parameters))
    return ToolInfo(name=tool.name, description=tool.description, parameters=parameters)
