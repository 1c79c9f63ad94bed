"""What people say of questions, in a file beside the records. Knows no truth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

import pydantic

from probe.episodes.files import append_line
from probe.errors import BadData
from probe.files import alone, fault, write_bytes
from probe.reading import contents, is_there

REMARKS = "remarks.jsonl"
LONGEST = 1000
"""Characters of a note."""


@dataclass(frozen=True)
class Remark:
    """What a person says of a question; a later one of the same person takes its place.

    Attributes:
        task: The question.
        agent: Name of the person, as in the records.
        ambiguous: Whether they call it ambiguous.
        note: Why, in their words.
    """

    task: str
    agent: str
    ambiguous: bool
    note: str = ""


class RemarkDocument(pydantic.BaseModel, extra="forbid"):
    """A line of the file."""

    task: str
    agent: str
    ambiguous: bool
    note: str = pydantic.Field(max_length=LONGEST)


def add_remark(out: Path, remark: Remark) -> None:
    """Add a remark to a started folder.

    Raises:
        BadData: The file ends in half a line.
        OutputFailed: It can't be written; nothing of it is left.
    """
    with alone(out):
        append_line(out / REMARKS, _line(remark))


def write_remarks(out: Path, remarks: Iterable[Remark]) -> None:
    """Write a whole file of remarks or none.

    Raises:
        OutputFailed: It can't be written.
    """
    write_bytes(out / REMARKS, b"".join(map(_line, remarks)))


def read_remarks(out: Path) -> list[Remark]:
    """All remarks of a folder in the order of their writing; none if nobody made any.

    Raises:
        BadData: A line is no remark.
    """
    path = out / REMARKS
    if not is_there(path):
        return []
    try:
        lines = contents(path).splitlines()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    return [_read(f"{path}, line {number}", line) for number, line in enumerate(lines, start=1)]


def latest(remarks: Iterable[Remark]) -> dict[tuple[str, str], Remark]:
    """By task and person, what they said last."""
    return {(remark.task, remark.agent): remark for remark in remarks}


def _line(remark: Remark) -> bytes:
    return RemarkDocument(**asdict(remark)).model_dump_json().encode() + b"\n"


def _read(place: str, line: bytes) -> Remark:
    try:
        return Remark(**RemarkDocument.model_validate_json(line).model_dump())
    except pydantic.ValidationError as error:
        raise BadData(place, fault(error, "the line"), "Delete this line") from error
