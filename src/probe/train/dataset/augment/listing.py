"""A list of perceive_scene taken apart, and put together again byte for byte. Texts alone."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass

Place = tuple[int, int]
Box = tuple[int, int, int, int]
Relation = tuple[int, str, int]

_ENTRY = re.compile(
    r"- number: (\d+)\n  object_id: (object_\d+)\n((?:  name: [^\n]*\n)?  description: [^\n]*\n)"
    r"  point: \[(\d+), (\d+)\]\n  box: \[(\d+), (\d+), (\d+), (\d+)\]\n"
)
_NAME = re.compile(r'name: ("[^\n]*")')
SAID = re.compile(r'(?P<name>name: )(?P<is>"[^\n]*")(?P<then>\n\s*description: )(?P<said>"[^\n]*")')
"""A name and a description in a list, each in quotation marks."""
_RELATION = re.compile(r"- (\d+) ([a-z_]+) (\d+)\n")
_OBJECTS, _RELATIONS, _CLUTTERED, _CLEAR = (
    "\nobjects:\n",
    "\nrelations:",
    "\ncluttered: ",
    "\nclear: ",
)


@dataclass(frozen=True)
class ListedThing:
    """An entry.

    Attributes:
        object_id: Its handle.
        words: The lines with its name and description.
        point: (u, v), pixels.
        box: Left, top, right, bottom, pixels, the last two included.
    """

    object_id: str
    words: str
    point: Place
    box: Box

    @property
    def name(self) -> str | None:
        """What it is; None where too little of it shows to be named."""
        found = _NAME.search(self.words)
        return json.loads(found[1]) if found else None


@dataclass(frozen=True)
class Listing:
    """A list.

    Attributes:
        comments: What stands before the entries, before the relations and before the ninths.
        things: The entries, in order.
        relations: Between them, by their place in the list from 0.
        cluttered, clear: Ninths of the picture.
    """

    comments: tuple[str, str, str]
    things: tuple[ListedThing, ...]
    relations: tuple[Relation, ...]
    cluttered: tuple[str, ...]
    clear: tuple[str, ...]

    @property
    def text(self) -> str:
        """As perceive_scene tells it."""
        first, second, third = self.comments
        entries = "".join(_entry_lines(n, it) for n, it in enumerate(self.things, start=1))
        lines = "".join(f"- {a + 1} {kind} {b + 1}\n" for a, kind, b in self.relations)
        related = f"\nrelations:\n{lines}" if lines else "\nrelations: []\n"
        regions = f"cluttered: [{', '.join(self.cluttered)}]\nclear: [{', '.join(self.clear)}]"
        return f"{first}{_OBJECTS}{entries}{second}{related}{third}\n{regions}"


def read_listing(text: str) -> Listing | None:
    """A list taken apart; None for one without things, or any other text."""
    first, found, rest = text.partition(_OBJECTS)
    entries = list(_entries(rest))
    end = entries[-1].end() if entries else 0
    second, related, rest = rest[end:].partition(_RELATIONS)
    relations = list(_RELATION.finditer(rest))
    third, cut, regions = rest.partition(_CLUTTERED)
    cluttered, _, clear = regions.partition(_CLEAR)
    if not (found and related and cut):
        return None
    listing = Listing(
        (first, second, third[relations[-1].end() if relations else len(" []\n") :]),
        tuple(_thing(entry) for entry in entries),
        tuple((int(it[1]) - 1, it[2], int(it[3]) - 1) for it in relations),
        _names(cluttered),
        _names(clear),
    )
    return listing if listing.text == text else None


def said_of_things(text: str) -> Iterator[tuple[str, str]]:
    """Names in a list, in order, with descriptions; none in any other text."""
    for found in SAID.finditer(text):
        yield json.loads(found["is"]), json.loads(found["said"])


def _entries(text: str) -> Iterator[re.Match[str]]:
    """The entries that a text begins with."""
    at = 0
    while entry := _ENTRY.match(text, at):
        yield entry
        at = entry.end()


def _thing(entry: re.Match[str]) -> ListedThing:
    _, id, words, u, v, left, top, right, bottom = entry.groups()
    box = (int(left), int(top), int(right), int(bottom))
    return ListedThing(id, words, (int(u), int(v)), box)


def _entry_lines(number: int, it: ListedThing) -> str:
    places = f"  point: {list(it.point)}\n  box: {list(it.box)}\n"
    return f"- number: {number}\n  object_id: {it.object_id}\n{it.words}{places}"


def _names(text: str) -> tuple[str, ...]:
    return tuple(text.removeprefix("[").removesuffix("]").split(", ")) if text != "[]" else ()
