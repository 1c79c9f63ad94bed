"""How models that point write places down, in a file beside the records that there are so far."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_text
from probe.perception.points import Convention
from probe.reading import is_there

CONVENTIONS = "pointing.json"

Conventions = Mapping[tuple[str, str], Convention]
"""By agent and setting, as records have both; the setting names who points."""


class _Line(pydantic.BaseModel, frozen=True, extra="forbid"):
    agent: str
    setting: str
    pointing: Convention


class ConventionsDocument(pydantic.BaseModel, frozen=True, extra="forbid"):
    """The file."""

    pointers: tuple[_Line, ...]


def read_conventions(out: Path) -> Conventions:
    """Those of a folder; nothing is known of agents that aren't there.

    Raises:
        BadData: The file can't be read.
    """
    path = out / CONVENTIONS
    if not is_there(path):
        return {}
    found = read_document(path, ConventionsDocument, "Delete it, and start the same run again")
    return {(it.agent, it.setting): it.pointing for it in found.pointers}


def check_convention(out: Path, agent: str, setting: str, pointing: Convention) -> None:
    """See that places in a folder, if there are any, were written down in the same way.

    Raises:
        BadData: They weren't, or the file can't be read.
    """
    before = read_conventions(out).get((agent, setting), pointing)
    if before != pointing:
        reason = f"was begun with pointing={before} for {agent} ({setting}), not {pointing}"
        as_before = f"Name the model as before (in Inspect, say -T pointing={before})"
        remedy = f"{as_before}, or choose another folder"
        raise BadData(out / CONVENTIONS, reason, remedy)


def claim_convention(out: Path, agent: str, setting: str, pointing: Convention) -> None:
    """Write down how places are, or see that it was begun in the same way.

    Raises:
        BadData: It wasn't, or the file can't be read.
        OutputFailed: It can't be written.
    """
    check_convention(out, agent, setting, pointing)
    earlier, key = read_conventions(out), (agent, setting)
    if key not in earlier:
        write_conventions(out, {**earlier, key: pointing})


def write_conventions(out: Path, conventions: Conventions) -> None:
    """Write down all conventions of a folder; of none no file is made.

    Raises:
        OutputFailed: It can't be written.
    """
    if not conventions:
        return
    lines = [
        _Line(agent=agent, setting=setting, pointing=pointing)
        for (agent, setting), pointing in conventions.items()
    ]
    document = ConventionsDocument(pointers=tuple(lines))
    write_text(out / CONVENTIONS, document.model_dump_json(indent=1) + "\n")


def joined_conventions(parts: Iterable[Path]) -> Conventions:
    """The conventions of several folders together.

    Raises:
        BadData: Two folders have different ones for an agent in a setting, or a file can't be read.
    """
    known: dict[tuple[str, str], Convention] = {}
    for part in parts:
        for (agent, setting), pointing in read_conventions(part).items():
            before = known.setdefault((agent, setting), pointing)
            if before != pointing:
                reason = f"was run with pointing={pointing} for {agent}, another folder {before}"
                raise BadData(part, reason, "Merge runs with the same one")
    return known
