"""The five tools as a model reads of them: the toolshed's own texts, places counted its way."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

from probe.episodes.participation import Points
from probe.toolshed.tools import ToolSchema, tool_schemas
from probe.transcripts.coordinates import check_countable, told
from probe.transcripts.prompts import Setting, tool_words
from probe.types import USUAL_SCALE, PictureScale


def tools_for(
    points: Points, scale: PictureScale = USUAL_SCALE, setting: Setting = "agentic"
) -> tuple[ToolSchema, ...]:
    """All five tools; in pixels they are the toolshed's, byte for byte; see check_countable().

    Where no pictures come with their results, less is said of them.
    """
    tools = tool_schemas(scale, tool_words(setting))
    check_countable(points, scale)
    return tools if points == "pixels" else tuple(map(_counted, tools))


def _counted(tool: ToolSchema) -> ToolSchema:
    return ToolSchema(tool.name, told(tool.description, "0-1000"), _in_thousandths(tool.parameters))


def _in_thousandths(schema: Any) -> Any:
    """A schema with its texts and its limits of places changed."""
    if isinstance(schema, str):
        return told(schema, "0-1000")
    if isinstance(schema, list):
        return [_in_thousandths(part) for part in cast("list[Any]", schema)]
    if not isinstance(schema, dict):
        return schema
    parts = dict(cast("dict[str, Any]", schema))
    if parts.get("exclusiveMaximum") == USUAL_SCALE.side_px:
        del parts["exclusiveMaximum"]
        parts = {"maximum": 1000, **parts}
    return {name: _in_thousandths(part) for name, part in parts.items()}


def expressible(schema: Mapping[str, Any], limits: bool = True) -> dict[str, Any]:
    """A schema without what the harness can't pass on and some servers refuse.

    Of a place that leaves a list of numbers; the toolshed checks the rest, as it always does.

    Args:
        schema: Of a tool's parameters, or a part of it.
        limits: Keep the limits of numbers and texts.
    """
    left_out = _LEFT_OUT if limits else _LEFT_OUT | _LIMITS
    parts = {name: _part(value, limits) for name, value in schema.items() if name not in left_out}
    if "prefixItems" in schema:
        parts["items"] = expressible(schema["prefixItems"][0], limits)
    return parts


def as_sent(
    points: Points, scale: PictureScale = USUAL_SCALE, setting: Setting = "agentic"
) -> list[dict[str, Any]]:
    """The five tools as servers that speak OpenAI's protocol get them, the order of keys included.

    A template writes them out as they come: training has to see the same. The harness tells such
    servers no limits, and that arguments must fit the schema.
    """
    return [
        {
            "type": "function",
            "function": {
                "name": tool.name,
                "description": tool.description,
                "parameters": _in_order({"required": [], **expressible(tool.parameters, False)}),
                "strict": True,
            },
        }
        for tool in tools_for(points, scale, setting)
    ]


_LEFT_OUT = {"prefixItems", "minItems", "maxItems", "exclusiveMaximum", "default"}
_LIMITS = {"minimum", "maximum", "minLength", "maxLength"}
_ORDER = (
    "type",
    "description",
    "enum",
    "items",
    "properties",
    "anyOf",
    "required",
    "additionalProperties",
)


def _part(value: Any, limits: bool) -> Any:
    if isinstance(value, dict):
        return expressible(cast("dict[str, Any]", value), limits)
    if isinstance(value, list):
        return [_part(each, limits) for each in cast("list[Any]", value)]
    return value


def _in_order(schema: Any) -> Any:
    """A schema with its keys in the harness's order; properties keep their own."""
    if isinstance(schema, list):
        return [_in_order(each) for each in cast("list[Any]", schema)]
    if not isinstance(schema, dict):
        return schema
    parts = cast("dict[str, Any]", schema)
    names = sorted(parts, key=_ORDER.index)
    return {
        name: {key: _in_order(each) for key, each in parts[name].items()}
        if name == "properties"
        else _in_order(parts[name])
        for name in names
    }
