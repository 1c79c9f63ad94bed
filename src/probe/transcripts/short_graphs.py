"""Lists of perceive_scene in few words: a line for each thing, and later lists tell changes alone.

Knows no places but pixels'.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from probe.agents.reading import Graph, Seen, read_graph

_FIRST = (
    "# All that shows, from top to bottom: object_id, what it is, [u, v] of a point on it, [width, "
    "height] of its box, what it lies on or covers."
)
_LATER = "# Changed since the last list:"
_SAME = "# Nothing has changed since the last list."
_EMPTY = "# Nothing shows."

_CONTACTS = ("on", "covering")

_STILL_PX = 2
"""By how much a point or a box may differ from what was told before it is told again."""


@dataclass(frozen=True)
class ListEntry:
    """A thing in a list.

    Attributes:
        what: It is.
        point: Pixel (u, v) on it.
        size: Width and height of its box, pixels; none where the box itself is told.
        lying: What it lies on or covers.
    """

    what: str
    point: tuple[int, int]
    size: tuple[int, int] | None = None
    lying: tuple[str, ...] = ()

    def line(self, object_id: str) -> str:
        """All of it."""
        told = f"- {object_id} {self.what} {list(self.point)}"
        if self.size:
            told += f" {list(self.size)}"
        return " ".join([told, ", ".join(self.lying)]) if self.lying else told

    def is_told_by(self, other: ListEntry | None) -> bool:
        """Whether nothing of it is new, up to two pixels, to who knows another entry of it."""
        if other is None or (self.what, self.lying) != (other.what, other.lying):
            return False
        return _still(self.point, other.point) and _still(self.size, other.size)


def entries_of(text: str) -> dict[str, ListEntry] | None:
    """The things of a list by their object_ids; None for another text, or a list without ids."""
    if "\nobjects:" not in text:
        return None
    graph = read_graph(text)
    ids = {seen.number: seen.object_id for seen in graph.objects if seen.object_id}
    if len(ids) < len(graph.objects):
        return None
    return {ids[seen.number]: _entry(seen, graph, ids) for seen in graph.objects}


def known_after(
    known: Mapping[str, ListEntry] | None, now: Mapping[str, ListEntry]
) -> dict[str, ListEntry]:
    """What somebody knows of the things of a list who was told it in few words.

    Args:
        known: What was known before; None if this is the first list.
        now: What the list has to tell.
    """
    before = known or {}
    return {id: before[id] if it.is_told_by(before.get(id)) else it for id, it in now.items()}


def _still(now: tuple[int, int] | None, before: tuple[int, int] | None) -> bool:
    """Whether two numbers are about what they were."""
    if now is None or before is None:
        return now is before
    return all(abs(a - b) <= _STILL_PX for a, b in zip(now, before, strict=True))


def short_list(known: Mapping[str, ListEntry] | None, now: Mapping[str, ListEntry]) -> str:
    """A list in few words; see known_after() for the arguments."""
    if known is None:
        lines = [entry.line(id) for id, entry in now.items()]
        return "\n".join([_FIRST, *lines]) if lines else _EMPTY
    told = [it.line(id) for id, it in now.items() if not it.is_told_by(known.get(id))]
    if over := [id for id in known if id not in now]:
        told.append(f"out of date: {', '.join(over)}")
    return "\n".join([_LATER, *told]) if told else _SAME


def _entry(seen: Seen, graph: Graph, ids: Mapping[int, str]) -> ListEntry:
    lying = tuple(
        f"{kind} {ids[below]}"
        for above, kind, below in graph.relations
        if above == seen.number and kind in _CONTACTS
    )
    return ListEntry(seen.name or seen.description, seen.point, seen.size, lying)
