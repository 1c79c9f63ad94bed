"""Records in a file, one line each."""

from __future__ import annotations

import os
from collections.abc import Sequence
from io import FileIO
from pathlib import Path

import pydantic

from probe import reading
from probe.episodes.document import EpisodeDocument
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, OutputFailed
from probe.files import write_bytes

_REMEDY = "Delete this line (the others are whole) and run the episode again"


def line_of(record: EpisodeRecord, *, timed: bool = True) -> bytes:
    """A record as one line of JSON; without timing, equal episodes give equal bytes."""
    return EpisodeDocument.of(record, timed=timed).model_dump_json().encode() + b"\n"


def record_of(line: bytes) -> EpisodeRecord:
    """The record of a line that line_of wrote.

    Raises:
        BadData: It is no record of this version.
    """
    return _read("record", line)


def write_records(path: Path, records: Sequence[EpisodeRecord]) -> None:
    """Write a whole file of records or none.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    write_bytes(path, b"".join(line_of(record) for record in records))


def append_record(path: Path, record: EpisodeRecord) -> None:
    """Add a record to a file, or start one; see append_line."""
    append_line(path, line_of(record))


def append_line(path: Path, line: bytes) -> None:
    """Add a line, its end included, to a file of records; all of it or nothing.

    Only a process that is killed while it writes, or a machine that stops, leaves a line cut off.

    Raises:
        BadData: The file ends in half a line.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    if cut_off(path):
        last = reading.contents(path, reading.RECORDS).count(b"\n") + 1
        raise BadData(f"{path}, line {last}", "is cut off before its end", _REMEDY)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("ab", buffering=0) as file:
            _write_whole(file, line)
    except OSError as error:
        raise OutputFailed(path, error) from error


def cut_off(path: Path) -> bytes:
    """What follows the last whole line of a file; empty if all are whole or there is no file.

    Raises:
        BadData: It can't be read.
    """
    if not path.exists():
        return b""
    try:
        return reading.contents(path, reading.RECORDS).rpartition(b"\n")[2]
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error


def set_aside_cut(path: Path) -> Path | None:
    """Move a last line that was cut off to a file beside it.

    Returns:
        That file; None if all lines are whole.

    Raises:
        OutputFailed: There is no room for it; nothing has changed then.
    """
    rest = cut_off(path)
    if not rest:
        return None
    aside = path.with_name(f"{path.name}.cut")
    append_line(aside, rest + b"\n")
    try:
        os.truncate(path, path.stat().st_size - len(rest))
    except OSError as error:
        raise OutputFailed(path, error) from error
    return aside


def read_records(path: Path, *, whole: bool = True) -> list[EpisodeRecord]:
    """Read all records of a file.

    Args:
        path: The file.
        whole: Refuse a last line that was cut off; otherwise it is left out.

    Raises:
        BadData: The file is missing, or a line is cut off or no record of this version.
    """
    try:
        content = reading.contents(path, reading.RECORDS)
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    lines = (content if whole else content[: content.rfind(b"\n") + 1]).splitlines()
    return [_read(f"{path}, line {number}", line) for number, line in enumerate(lines, start=1)]


def _write_whole(file: FileIO, line: bytes) -> None:
    """Write to the end of a file that isn't buffered; what had room alone is taken back."""
    before = file.seek(0, os.SEEK_END)
    try:
        written = 0
        while written < len(line):
            written += file.write(line[written:])
        os.fsync(file.fileno())
    except OSError:
        file.truncate(before)
        raise


def _read(place: str, line: bytes) -> EpisodeRecord:
    try:
        return EpisodeDocument.model_validate_json(line).record()
    except pydantic.ValidationError as error:
        first = error.errors(include_input=False)[0]
        field = ".".join(str(part) for part in first["loc"])
        reason = f"{field}: {first['msg']}" if field else first["msg"]
        raise BadData(place, reason, _REMEDY) from error
