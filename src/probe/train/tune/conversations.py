"""Conversations as a processor takes them: rows of a data set, requests to a server. One form.

What a model is trained on must be what a server makes of the same episode, token by token.
"""

from __future__ import annotations

import base64
import binascii
import io
import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

from PIL import Image

from probe.errors import ProbeError

Conversation = list[dict[str, Any]]
"""Messages with lists of parts; pictures are in their places."""


class NotUnderstood(ProbeError):
    """A request that isn't in OpenAI's form of a chat."""

    def __init__(self, reason: str) -> None:
        super().__init__(f"The request isn't understood: {reason}.")


def of_row(row: Mapping[str, Any]) -> Conversation:
    """A row that `probe dataset` wrote, as `datasets` reads it."""
    pictures: Iterator[Any] = iter(row.get("images") or ())
    return [
        _message(
            message["role"],
            [
                {"type": "image", "image": next(pictures)} if it["type"] == "image" else _text(it)
                for it in message["content"]
            ],
            message.get("tool_calls"),
        )
        for message in row["messages"]
    ]


def tools_of_row(row: Mapping[str, Any]) -> list[dict[str, Any]] | None:
    """What may be called in a row; None without tools."""
    return json.loads(row["tools"]) if row["tools"] else None


def of_request(messages: Sequence[Mapping[str, Any]]) -> Conversation:
    """The messages of a request in OpenAI's form.

    Raises:
        NotUnderstood: They aren't in that form, or there are none.
    """
    if not messages:
        raise NotUnderstood("it has no messages")
    try:
        return [
            _message(message["role"], _parts(message.get("content")), message.get("tool_calls"))
            for message in messages
        ]
    except (KeyError, TypeError, AttributeError) as error:
        raise NotUnderstood(f"a message lacks {error}") from error


def _parts(content: str | Sequence[Mapping[str, Any]] | None) -> list[dict[str, Any]]:
    if not content:
        return []
    if isinstance(content, str):
        return [{"type": "text", "text": content}]
    return [
        {"type": "image", "image": _picture(it["image_url"]["url"])}
        if it["type"] == "image_url"
        else _text(it)
        for it in content
    ]


def _message(
    role: str, parts: list[dict[str, Any]], calls: Sequence[Mapping[str, Any]] | None
) -> dict[str, Any]:
    said: dict[str, Any] = {"role": role, "content": parts}
    if calls:
        said["tool_calls"] = [_call(it["function"]) for it in calls]
    return said


def _call(function: Mapping[str, Any]) -> dict[str, Any]:
    """A call with its arguments as values, which the template writes in its own way."""
    arguments = function["arguments"]
    with suppress(ValueError):  # what is no JSON stands in the conversation as it was said
        arguments = json.loads(arguments)
    return {"type": "function", "function": {"name": function["name"], "arguments": arguments}}


def _text(part: Mapping[str, Any]) -> dict[str, Any]:
    if part["type"] != "text":
        raise NotUnderstood(f"parts of type {part['type']!r} can't be shown")
    return {"type": "text", "text": part["text"]}


def _picture(address: str) -> Image.Image:
    """A picture that stands in its own address; none is fetched from anywhere."""
    _, found, content = address.partition(";base64,")
    try:
        if not found:
            raise ValueError("it isn't part of the request")
        return Image.open(io.BytesIO(base64.b64decode(content))).convert("RGB")
    except (binascii.Error, OSError, ValueError, Image.DecompressionBombError) as error:
        raise NotUnderstood(f"a picture can't be read ({error})") from error
