"""A model's reply as our records and the harness's log can hold it, whatever stands in it."""

from __future__ import annotations

from typing import Any, cast

from inspect_ai.model import ModelCall, ModelOutput
from pydantic_core import PydanticSerializationError

from probe.bench.reasoning_tags import TooManyTags
from probe.texts import writable

_TOO_LONG, _TOO_DEEP = "integer string conversion", "depth exceeded"
"""In what Python says of a number with thousands of digits, and pydantic of nested lists."""


def writable_output(output: ModelOutput) -> ModelOutput:
    """The reply itself, or one like it whose texts UTF-8 can hold."""
    return cast("ModelOutput", _made_writable(output))


def writable_call(call: ModelCall) -> ModelCall:
    """What went over the wire, in the same way."""
    return cast("ModelCall", _made_writable(call))


def made_writable(error: Exception) -> None:
    """Make what an error says such that it can be told; a server may put anything there."""
    error.args = tuple(_cleaned(list(error.args)))
    for name in ("message", "body"):
        said = getattr(error, name, None)
        if isinstance(said, str | list | dict):
            setattr(error, name, _cleaned(said))


def unreadable(error: Exception) -> str | None:
    """What of a reply that has come no client can read; None if that isn't why it failed.

    A server that sent something else than a reply is no such case: it can be asked again.
    """
    if isinstance(error, RecursionError) or _TOO_DEEP in str(error):
        return "it is nested too deep"
    if isinstance(error, TooManyTags):
        return str(error)
    if _TOO_LONG in str(error):
        return "a number in it has too many digits"
    return None


def _made_writable(value: ModelOutput | ModelCall) -> ModelOutput | ModelCall:
    try:
        value.model_dump_json()
    except (PydanticSerializationError, UnicodeEncodeError):
        return type(value).model_validate(_cleaned(value.model_dump()))
    return value


def _cleaned(value: Any) -> Any:
    """Lists and mappings with all texts in them made writable, names too."""
    if isinstance(value, str):
        return writable(value)
    if isinstance(value, list):
        return [_cleaned(each) for each in cast("list[Any]", value)]
    if isinstance(value, dict):
        parts = cast("dict[Any, Any]", value)
        return {_cleaned(name): _cleaned(part) for name, part in parts.items()}
    return value
