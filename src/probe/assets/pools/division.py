"""Which built-in objects are for training and which for evaluation, as stored with the catalogue.

`dividing.py` says how they were divided. An object that is there keeps its place for good.
"""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from importlib.resources import files
from typing import Literal, NamedTuple, cast

from probe.errors import BadData

Part = Literal["train", "evaluation"]
PARTS: tuple[Part, ...] = ("train", "evaluation")
Shown = Literal["train", "evaluation", "both"]
"""Of which part objects are; "both" if some are of each."""

DIVISION = "pools.csv"
_COLUMNS = ["object", "group", "pool"]


class DividedObject(NamedTuple):
    """A line of ``data/pools.csv``.

    Attributes:
        id: The object's.
        group: The first id of its group of near-duplicates, which is its own if it has none.
        part: Which pool it belongs to.
    """

    id: str
    group: str
    part: Part


@cache
def divided() -> Mapping[str, DividedObject]:
    """All built-in objects by id.

    Raises:
        BadData: The file has been damaged.
    """
    text = (files("probe.assets") / "data" / DIVISION).read_text("utf-8")
    return {row.id: row for row in parse_division(text)}


def part_of_object(object_id: str) -> Part | None:
    """Which pool a built-in object belongs to; None of any other object, such as a scan."""
    row = divided().get(object_id)
    return row and row.part


def parts_shown(ids: Iterable[str]) -> Counter[Part | None]:
    """How many different objects are of which part; None counts what isn't built in."""
    return Counter(part_of_object(object_id) for object_id in set(ids))


def shown_of(ids: Iterable[str]) -> Shown | None:
    """Of which part objects are; None if none of them is built in."""
    found = parts_shown(ids)
    if found["train"] and found["evaluation"]:
        return "both"
    return "train" if found["train"] else "evaluation" if found["evaluation"] else None


def parse_division(text: str) -> Sequence[DividedObject]:
    """The lines of a file's text.

    Raises:
        BadData: One has no such pool, has too little or too much, or is there twice.
    """
    header, *lines = csv.reader(io.StringIO(text), strict=True)
    remedy = "Make it again: scripts/divide_objects.py"
    if header != _COLUMNS:
        raise BadData(DIVISION, f"has the columns {', '.join(header)}", remedy)
    for number, line in enumerate(lines, start=2):
        if len(line) != len(_COLUMNS) or line[2] not in PARTS:
            raise BadData(DIVISION, f"line {number} is {','.join(line)!r}", remedy)
    rows = [DividedObject(id, group, cast(Part, part)) for id, group, part in lines]
    if len({row.id for row in rows}) < len(rows):
        raise BadData(DIVISION, "an object is there twice", remedy)
    return rows


def division_text(rows: Iterable[DividedObject]) -> str:
    """The text of the file, objects in the order of their ids."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_COLUMNS)
    writer.writerows(sorted(rows))
    return text.getvalue()
