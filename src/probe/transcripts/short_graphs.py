"""Lists of perceive_scene in few words: a line for each thing, and later lists tell changes alone.

Knows no places but pixels'.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from probe.agents.reading import Graph, Seen, read_graph

_FIRST = (
    "# All that shows, from top to bottom: object_id, what it is, [u, v] of a point on it, what it "
    "lies on or covers."
)
_LATER = "# Changed since the last list:"
_SAME = "# Nothing has changed since the last list."
_EMPTY = "# Nothing shows."

_CONTACTS = ("on", "covering")


@dataclass(frozen=True)
class ListEntry:
    """A thing in a list: what it is, (u, v) of a point on it, and what it lies on or covers."""

    what: str
    point: tuple[int, int]
    lying: tuple[str, ...] = ()

    def line(self, object_id: str) -> str:
        """All of it."""
        told = f"- {object_id} {self.what} {list(self.point)}"
        return " ".join([told, ", ".join(self.lying)]) if self.lying else told

    def tells_as_much_as(self, other: ListEntry | None) -> bool:
        """Whether nothing is new: a thing that kept its id is where it was, whatever its point."""
        return other is not None and (self.what, self.lying) == (other.what, other.lying)


def entries_of(text: str) -> dict[str, ListEntry] | None:
    """The things of a list by their object_ids; None for another text, or a list without ids."""
    if "\nobjects:" not in text:
        return None
    graph = read_graph(text)
    ids = {seen.number: seen.object_id for seen in graph.objects if seen.object_id}
    if len(ids) < len(graph.objects):
        return None
    return {ids[seen.number]: _entry(seen, graph, ids) for seen in graph.objects}


def short_list(before: Mapping[str, ListEntry] | None, now: Mapping[str, ListEntry]) -> str:
    """A list in few words.

    Args:
        before: What the list before this one told; None if this is the first.
        now: What it has to tell.
    """
    if before is None:
        lines = [entry.line(id) for id, entry in now.items()]
        return "\n".join([_FIRST, *lines]) if lines else _EMPTY
    fresh = [id for id, entry in now.items() if not entry.tells_as_much_as(before.get(id))]
    told = [now[id].line(id) for id in fresh]
    if over := [id for id in before if id not in now]:
        told.append(f"out of date: {', '.join(over)}")
    return "\n".join([_LATER, *told]) if told else _SAME


def _entry(seen: Seen, graph: Graph, ids: Mapping[int, str]) -> ListEntry:
    lying = tuple(
        f"{kind} {ids[below]}"
        for above, kind, below in graph.relations
        if above == seen.number and kind in _CONTACTS
    )
    return ListEntry(seen.name or seen.description, seen.point, lying)
