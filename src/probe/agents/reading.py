"""Reads the tools' texts as an agent would: what shows, which handle, how it went."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, cast

import yaml

from probe.errors import ProbeError
from probe.perception.tokens import tokens
from probe.toolshed.result import LAST_TURN

Box = tuple[int, int, int, int]

Outcome = Literal["gone", "pushed", "lost", "no grip", "blocked", "unfound"]
"""What came of a manipulation: the thing left its place for the basket or fell elsewhere; was
pushed; slipped out of the hand; couldn't be gripped; or the hand was stopped; or nothing was tried,
since the thing wasn't found."""

# Words of the tool's replies to a grasp, and what they mean.
_GRASPED: Mapping[str, Outcome] = {
    "shows neither on the table": "gone",
    "was not found again": "gone",
    "no place to grip": "no grip",
    "no grip on": "no grip",
    "still on the table": "lost",
    "lost it while lifting": "lost",
}


# Words of the tools' replies to a grasp or a push; see probe.toolshed.outcomes.
_AWAY = re.compile(
    r"(object_\d+) (?:was lifted and dropped into|ended up in|lies in|lies beside) the basket"
)
_REFUSED = re.compile(r"There is no object_id |\S+ is out of date: ")
_RENAMED = re.compile(r"\b[Ii]t is (object_\d+) now\b")
_ALSO_RENAMED = re.compile(r"\((object_\d+) now\)")

_SHORT_LIST = re.compile(r"^- object_\d+ |^# (?:Nothing shows|.* since the last list)\b", re.M)

_LISTS = ("objects", "others_that_fit_as_well", "others_that_may_be_meant")
_NEAREST = re.compile(r"(object_\d+), (.*?), at \[")


@dataclass(frozen=True)
class Seen:
    """One entry of perceive_scene's list.

    Attributes:
        number: Its number in the list.
        name: What it is; None where too little of it shows to be named.
        description: What the list says of it.
        point: A pixel (u, v) on it, or thousandths if the agent's texts have these.
        box: Left, top, right and bottom pixel, the last two included.
        size: Width and height of the box in pixels.
        area: Pixels of the box.
        object_id: Its handle; None where the list gives none.
        place: Words by which find_object finds it.
    """

    number: int
    name: str | None
    description: str
    point: tuple[int, int]
    box: Box
    object_id: str | None = None

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of its box in pixels."""
        left, top, right, bottom = self.box
        return right - left + 1, bottom - top + 1

    @property
    def area(self) -> int:
        """Pixels of its box."""
        width, height = self.size
        return width * height

    @property
    def place(self) -> str:
        """Words by which find_object finds it."""
        return f"the thing at ({self.point[0]}, {self.point[1]})"


@dataclass(frozen=True)
class Graph:
    """What a reply of perceive_scene says.

    Attributes:
        objects: All entries of the list.
        relations: Number, word ("on", "covering", "touching", ...) and number of two entries.
        named: The entries that show enough to be named.
        unclear: The other entries.
    """

    objects: tuple[Seen, ...] = ()
    relations: tuple[tuple[int, str, int], ...] = ()

    @property
    def named(self) -> tuple[Seen, ...]:
        """Those that show enough to be named."""
        return tuple(seen for seen in self.objects if seen.name is not None)

    @property
    def unclear(self) -> tuple[Seen, ...]:
        """Those that don't."""
        return tuple(seen for seen in self.objects if seen.name is None)

    def called(self, name: str) -> tuple[Seen, ...]:
        """All that go by a name."""
        return tuple(seen for seen in self.named if seen.name and same(seen.name, name))

    def over(self, seen: Seen) -> set[int]:
        """Numbers of those that lie on it or cover it."""
        above = [r for r in self.relations if r[1] in ("on", "covering")]
        return {first for first, _, second in above if second == seen.number}

    def touching(self, seen: Seen) -> set[int]:
        """Numbers of those that it only touches: neither lies on the other or covers it."""
        ends = [(a, b) for a, kind, b in self.relations if kind == "touching"]
        return {b for a, b in ends if a == seen.number} | {a for a, b in ends if b == seen.number}

    def meeting(self, seen: Seen) -> set[int]:
        """Numbers of those that lie on, cover or touch it, or the other way round."""
        contacts = [r for r in self.relations if r[1] in ("on", "covering", "touching")]
        ends = {(a, b) for a, _, b in contacts} | {(b, a) for a, _, b in contacts}
        return {other for one, other in ends if one == seen.number}


class ShortList(ProbeError):
    """A list as models read it that are told graphs in short."""

    def __init__(self) -> None:
        super().__init__(
            "This list is in short (--graphs short): it has no boxes, and may tell only what has "
            "changed. Read the whole list instead; records keep it, and agents are told it."
        )


def read_graph(text: str) -> Graph:
    """Read a reply of perceive_scene; an empty graph if the text is something else.

    Raises:
        ShortList: It is a list in short, as some models are told it.
    """
    if _SHORT_LIST.search(text):
        raise ShortList
    if "objects:" not in text:
        return Graph()
    told = _loaded(text)
    if not isinstance(told, dict) or "objects" not in told:
        return Graph()
    content = cast("dict[str, Any]", told)
    objects = tuple(
        Seen(
            item["number"],
            item.get("name"),
            item["description"],
            _pair(item["point"]),
            _box(item["box"]),
            item.get("object_id"),
        )
        for item in content["objects"]
    )
    relations = tuple(_relation(line) for line in content["relations"])
    return Graph(objects, relations)


def read_handle(text: str) -> str | None:
    """The object_id in a reply of find_object; None if it found nothing."""
    first, _, _ = text.partition("\n")
    key, _, value = first.partition(": ")
    return value if key == "object_id" else None


def read_exact(text: str) -> list[str]:
    """The object_ids of all that find_object found which is called what was asked for."""
    if read_handle(text) is None:
        return []
    content = cast("dict[str, Any]", _loaded(text))
    others: list[Any] = content.get("others_that_fit_as_well") or []
    return [] if "note" in content else [it["object_id"] for it in (content, *others)]


def read_handles(text: str) -> dict[str, str]:
    """All object_ids in a reply of perceive_scene or find_object, with a name or description.

    Empty if the text is something else.
    """
    if " Nearest: " in text:
        return dict(_NEAREST.findall(text.rpartition(" Nearest: ")[2]))
    try:
        told = _loaded(text)
    except (yaml.YAMLError, ValueError, RecursionError):  # none that our tools wrote
        return {}
    if not isinstance(told, dict):
        return {}
    content = cast("dict[str, Any]", told)
    lists: list[Any] = [content.get(key) or () for key in _LISTS]
    items = (content, *(cast("dict[str, Any]", item) for each in lists for item in each))
    return {
        item["object_id"]: str(item.get("name") or item.get("description"))
        for item in items
        if "object_id" in item
    }


def _loaded(text: str) -> object:
    """What a reply lists, without what the last one says below."""
    listed, _, _ = text.partition(f"\n{LAST_TURN}")
    return yaml.load(listed, yaml.CSafeLoader)


def read_away(text: str) -> str | None:
    """The object_id of what a grasp or a push left in the basket, or beside it out of reach."""
    found = _AWAY.search(text)
    return found[1] if found else None


def read_new_handle(text: str) -> str | None:
    """The object_id that a thing has since a grasp or a push moved it; None if it kept its own."""
    found = _RENAMED.search(text)
    return found[1] if found else None


def read_new_handles(text: str) -> set[str]:
    """All object_ids that a grasp or a push gave to what it moved, things beside it included."""
    return {*_RENAMED.findall(text), *_ALSO_RENAMED.findall(text)}


def handle_refused(text: str) -> bool:
    """Whether a grasp or a push did nothing, since no tool gave its object_id out or it is old."""
    return _REFUSED.match(text) is not None


def grasp_outcome(text: str) -> Outcome:
    """What a reply of grasp_and_remove says."""
    if worked(text):
        return "gone"
    for words, what in _GRASPED.items():
        if words in text:
            return what
    return "blocked"


def worked(text: str) -> bool:
    """Whether a manipulation's reply says that it worked."""
    return text.startswith("Done:")


def same(one: str, other: str) -> bool:
    """Whether two names mean the same thing: articles, order and number of nouns aside."""
    return sorted(tokens(one)) == sorted(tokens(other))


def _pair(values: list[int]) -> tuple[int, int]:
    u, v = values
    return u, v


def _box(values: list[int]) -> Box:
    left, top, right, bottom = values
    return left, top, right, bottom


def _relation(line: str) -> tuple[int, str, int]:
    first, kind, second = line.split()
    return int(first), kind, int(second)
