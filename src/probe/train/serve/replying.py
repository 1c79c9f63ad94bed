"""A model's words as a reply with calls: Hermes' form, which Qwen's template writes. Pure."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Any, cast

_CALL = re.compile(r"<tool_call>\s*(.*?)\s*</tool_call>", re.DOTALL)
_START = "<tool_call>"


@dataclass(frozen=True)
class ServedReply:
    """What a model said.

    Attributes:
        words: Beside its calls.
        calls: Name and arguments of each, the latter as JSON text.
    """

    words: str
    calls: tuple[tuple[str, str], ...] = ()


def read_reply(text: str) -> ServedReply:
    """A reply; where a call can't be read all of it is words, as vLLM's parser has it.

    Words end without the line break that the template puts before a call: it would stand there
    twice when the conversation is told again.
    """
    if _START not in text:
        return ServedReply(text.strip())
    try:
        calls = tuple(_call(found) for found in _CALL.findall(text))
    except (ValueError, KeyError, TypeError, RecursionError):
        calls = ()
    return (
        ServedReply(text[: text.find(_START)].strip(), calls)
        if calls
        else ServedReply(text.strip())
    )


def _call(found: str) -> tuple[str, str]:
    values: Any = json.loads(found)
    called = cast("dict[str, Any]", values)
    return str(called["name"]), json.dumps(called["arguments"], ensure_ascii=False)
