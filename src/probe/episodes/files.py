"""Records in a file, one line each."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pydantic

from probe.episodes.document import EpisodeDocument
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import write_bytes

_REMEDY = "Delete this line (the others are whole) and run the episode again"


def line_of(record: EpisodeRecord, *, timed: bool = True) -> bytes:
    """A record as one line of JSON; without timing, equal episodes give equal bytes."""
    return EpisodeDocument.of(record, timed=timed).model_dump_json().encode() + b"\n"


def write_records(path: Path, records: Sequence[EpisodeRecord]) -> None:
    """Write a whole file of records or none.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    write_bytes(path, b"".join(line_of(record) for record in records))


def append_record(path: Path, record: EpisodeRecord) -> None:
    """Add a record to a file, or start one; the file is complete at any moment.

    Raises:
        BadData: The file ends in half a line.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    earlier = path.read_bytes() if path.exists() else b""
    if earlier and not earlier.endswith(b"\n"):
        last = earlier.count(b"\n") + 1
        raise BadData(f"{path}, line {last}", "is cut off before its end", _REMEDY)
    write_bytes(path, earlier + line_of(record))


def read_records(path: Path) -> list[EpisodeRecord]:
    """Read all records of a file.

    Raises:
        BadData: The file is missing, or a line is cut off or no record of this version.
    """
    try:
        lines = path.read_bytes().splitlines()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    return [_read(f"{path}, line {number}", line) for number, line in enumerate(lines, start=1)]


def _read(place: str, line: bytes) -> EpisodeRecord:
    try:
        return EpisodeDocument.model_validate_json(line).record()
    except pydantic.ValidationError as error:
        first = error.errors(include_input=False)[0]
        field = ".".join(str(part) for part in first["loc"])
        reason = f"{field}: {first['msg']}" if field else first["msg"]
        raise BadData(place, reason, _REMEDY) from error
