"""How many runs of each task were ordered, in a file beside the records that there are so far."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_text
from probe.reading import is_there

ORDERED = "ordered.json"

MOST_RUNS = 1000
"""Of each task, by one agent: more are a slip of the hand, or somebody's mischief. Each one that
isn't there is counted and named as missing."""

Ordered = Mapping[tuple[str, str], int]
"""Runs of each task by agent and setting, as records have both."""


class _Line(
    pydantic.BaseModel, frozen=True, extra="forbid", validate_by_name=True, serialize_by_alias=True
):
    agent: str
    setting: Annotated[str, pydantic.Field(alias="arm")]
    runs: int = pydantic.Field(ge=1, le=MOST_RUNS)


class OrderedDocument(pydantic.BaseModel, frozen=True, extra="forbid"):
    """The file."""

    ordered: tuple[_Line, ...]


def read_ordered(out: Path) -> Ordered:
    """What was ordered in a folder; nothing is known of agents that aren't there.

    Raises:
        BadData: The file can't be read.
    """
    path = out / ORDERED
    if not is_there(path):
        return {}
    found = read_document(path, OrderedDocument, "Delete it, and start the same run again")
    return {(it.agent, it.setting): it.runs for it in found.ordered}


def note_ordered(out: Path, agent: str, setting: str, runs: int) -> None:
    """Write down an order before it is carried out; of two orders the larger one stands.

    Raises:
        BadData: What is there can't be read.
        OutputFailed: It can't be written.
    """
    earlier, key = read_ordered(out), (agent, setting)
    if runs > earlier.get(key, 0):
        write_ordered(out, {**earlier, key: runs})


def write_ordered(out: Path, ordered: Ordered) -> None:
    """Write down all that was ordered in a folder.

    Raises:
        OutputFailed: It can't be written.
    """
    lines = [
        _Line(agent=agent, setting=setting, runs=runs) for (agent, setting), runs in ordered.items()
    ]
    document = OrderedDocument(ordered=tuple(lines))
    write_text(out / ORDERED, document.model_dump_json(indent=1) + "\n")


def joined(parts: Iterable[Path]) -> Ordered:
    """What was ordered in several folders together.

    Raises:
        BadData: Two folders have different numbers for an agent in a setting, or a file can't be
            read.
    """
    known: dict[tuple[str, str], int] = {}
    for part in parts:
        for (agent, setting), runs in read_ordered(part).items():
            before = known.setdefault((agent, setting), runs)
            if before != runs:
                reason = f"was to have {runs} runs of each task by {agent}, another folder {before}"
                raise BadData(part, reason, "Run all parts with the same number first")
    return known
