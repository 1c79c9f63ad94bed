"""Lists of perceive_scene in few words: a line for each thing, and later lists tell changes alone.

Knows no places but pixels'.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from probe.agents.reading import Graph, Seen, read_graph
from probe.perception.colour_words import colour_words_in, first_colours

# Small models read forwards: they find what follows a word, and hardly what stood before it. So an
# object_id stands on both sides of the point and the name, and "new" or "another" in front of what
# is told under an object_id for the first time.
_FIRST = (
    "# All that shows, from top to bottom: object_id, [u, v] on it, what it is, object_id, its "
    "[width, height], colours if its name has none, what lies on or covers it, what it touches if "
    'it has no name. In later lists "new" stands before names that this one lacks, "another" '
    "before new object_ids of names that it has."
)
_LATER = "# Changed since the last list:"
_SAME = "# Nothing has changed since the last list."
_EMPTY = "# Nothing shows."

_STILL_PX = 2
"""By how much a point or a box may differ from what was told before it is told again."""


@dataclass(frozen=True)
class ListEntry:
    """A thing in a list.

    Attributes:
        what: It is.
        point: Pixel (u, v) on it.
        mark: What stands before its name where its object_id and name are told together for the
            first time: "new" if nothing in the first list has the name, else "another"; empty for
            what has no name.
        size: Width and height of its box, pixels; none where the box itself is told.
        colours: Those that its description names first, if its name has none.
        under: The object_ids of what lies on it or covers it.
        touching: Those of what it touches, if too little of it shows to be named.
    """

    what: str
    point: tuple[int, int]
    mark: str = ""
    size: tuple[int, int] | None = None
    colours: str = ""
    under: tuple[str, ...] = ()
    touching: tuple[str, ...] = ()

    def line(self, object_id: str, *, marked: bool = False) -> str:
        """All of it."""
        mark = f", {self.mark}" if marked and self.mark else ""
        told = [f"- {object_id} at {list(self.point)}{mark}: {self.what}", object_id]
        told += [str(list(self.size))] if self.size else []
        told += [self.colours] if self.colours else []
        told += [f"under {' and '.join(self.under)}"] if self.under else []
        told += [f"touching {' and '.join(self.touching)}"] if self.touching else []
        return ", ".join(told)

    def beside(self, others: Collection[str]) -> ListEntry:
        """The same entry where only these others are left."""
        under, touching = (
            tuple(id for id in ids if id in others) for ids in (self.under, self.touching)
        )
        return replace(self, under=under, touching=touching)

    def is_told_by(self, other: ListEntry | None) -> bool:
        """Whether nothing of it is new, up to two pixels, to who knows another entry of it."""
        if other is None or (self.what, self.colours) != (other.what, other.colours):
            return False
        if {*self.under} != {*other.under} or {*self.touching} != {*other.touching}:
            return False
        return _still(self.point, other.point) and _still(self.size, other.size)


def listed_graph(text: str) -> Graph | None:
    """A list with object_ids; None for another text, or a list without ids."""
    if "\nobjects:" not in text:
        return None
    graph = read_graph(text)
    return graph if all(seen.object_id for seen in graph.objects) else None


def entries_of(graph: Graph, known: Collection[str | None]) -> dict[str, ListEntry]:
    """The things of a list by their object_ids.

    Args:
        graph: The list; all of it has object_ids.
        known: Names in the first list.
    """
    ids = {seen.number: seen.object_id or "" for seen in graph.objects}
    return {ids[seen.number]: _entry(seen, graph, ids, known) for seen in graph.objects}


def known_after(
    known: Mapping[str, ListEntry] | None, now: Mapping[str, ListEntry]
) -> dict[str, ListEntry]:
    """What somebody knows of the things of a list who was told it in few words.

    Args:
        known: What was known before; None if this is the first list.
        now: What the list has to tell.
    """
    before = _left_of(known or {}, now)
    return {id: before[id] if it.is_told_by(before.get(id)) else it for id, it in now.items()}


def _left_of(known: Mapping[str, ListEntry], now: Collection[str]) -> dict[str, ListEntry]:
    """What is known once it is told which object_ids are out of date."""
    return {id: entry.beside(now) for id, entry in known.items() if id in now}


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
    before = _left_of(known, now)
    told = [
        it.line(id, marked=id not in before or before[id].what != it.what)
        for id, it in now.items()
        if not it.is_told_by(before.get(id))
    ]
    if over := [id for id in known if id not in now]:
        told.append(f"out of date: {', '.join(over)}")
    return "\n".join([_LATER, *told]) if told else _SAME


def _entry(
    seen: Seen, graph: Graph, ids: Mapping[int, str], known: Collection[str | None]
) -> ListEntry:
    over = graph.over(seen)
    touching = set[int]() if seen.name else graph.touching(seen)
    under, beside = (tuple(ids[it] for it in sorted(numbers)) for numbers in (over, touching))
    return ListEntry(
        what=seen.name or seen.description,
        point=seen.point,
        mark="" if seen.name is None else "another" if seen.name in known else "new",
        size=seen.size,
        colours=_colours(seen),
        under=under,
        touching=beside,
    )


def _colours(seen: Seen) -> str:
    """What a description alone tells of a thing's colours."""
    if seen.name is None or colour_words_in(seen.name):
        return ""
    return first_colours(seen.description)
