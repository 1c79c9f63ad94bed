"""What tools reply, in few words: for models whose window is small.

A record keeps every reply whole. Knows no places but pixels'.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, cast

import yaml

from probe.toolshed.result import LAST_TURN, MOVING
from probe.transcripts.short_graphs import (
    ListEntry,
    entries_of,
    known_after,
    listed_graph,
    short_list,
)

_MOVED = re.compile(
    r"Also moved: .*?\. (?=(?:Also moved, and|May have moved|Beside the basket|Out of sight, and|"
    r"No longer to be seen|Not found again|Manipulations left)\b)"
)
_OTHERS = "Others moved, too. "
_LAST_TURN = f"\n{LAST_TURN}"

_FOUND = "object_id: "
_NEEDED = {"object_id", "description", "point", "box"}
_MORE = ("others_that_fit_as_well", "others_that_may_be_meant")


class ShortResults:
    """The replies to one episode's calls, one after another."""

    def __init__(self) -> None:
        self._names: frozenset[str | None] = frozenset()
        self._known: Mapping[str, ListEntry] | None = None

    def shortened(self, tool: str, text: str) -> str:
        """A reply in few words.

        After the first list, lists tell what changed; one without object_ids stays as it is. What
        else a grasp or a push has moved stands in the next list, and is only mentioned.

        Args:
            tool: That gave it.
            text: All of it, with places in pixels.
        """
        said, ends, end = text.partition(_LAST_TURN)
        return f"{self._short(tool, said)}{ends}{end}"

    def _short(self, tool: str, text: str) -> str:
        if tool in MOVING:
            return _MOVED.sub(_OTHERS, text)
        if tool == "find_object" and text.startswith(_FOUND):
            return _found(text)
        graph = listed_graph(text) if tool == "perceive_scene" else None
        if graph is None:
            return text
        known = self._known
        if known is None:
            self._names = frozenset(seen.name for seen in graph.named)
        entries = entries_of(graph, self._names)
        if entries or known is not None:  # an empty table is no first list
            self._known = known_after(known, entries)
        return short_list(known, entries)


def _found(text: str) -> str:
    """What find_object found as a line, with its box and description, then others that may fit."""
    content = cast("dict[str, Any]", yaml.load(text, yaml.CSafeLoader))
    if not content.keys() >= _NEEDED:  # which only tools of an earlier version leave out
        return text
    name, description = content.get("name"), str(content["description"])
    first = f"{_line(content, name or description)}, box {content['box']}"
    lines = [f"{first}: {description}" if name else first]
    if "note" in content:
        lines.append(f"note: {content['note']}")
    for heading in _MORE:
        if others := cast("list[dict[str, Any]]", content.get(heading, [])):
            lines += [f"{heading}:", *(_line(it, str(it["description"])) for it in others)]
    return "\n".join(lines)


def _line(content: Mapping[str, Any], what: str) -> str:
    u, v = content["point"]
    return ListEntry(what, (u, v)).line(content["object_id"])
