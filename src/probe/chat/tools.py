"""The five tools as a model reads of them: the toolshed's own texts, places counted its way."""

from __future__ import annotations

from typing import Any, cast

from probe.chat.coordinates import told
from probe.episodes.seat import Points
from probe.scene.layout import PICTURE_PX
from probe.toolshed.tools import ToolSchema, tool_schemas


def tools_for(points: Points) -> tuple[ToolSchema, ...]:
    """All five tools; in pixels they are the toolshed's, byte for byte."""
    return tool_schemas() if points == "pixels" else tuple(map(_counted, tool_schemas()))


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
    if parts.get("exclusiveMaximum") == PICTURE_PX:
        del parts["exclusiveMaximum"]
        parts = {"maximum": 1000, **parts}
    return {name: _in_thousandths(part) for name, part in parts.items()}
