"""Records in a file, one line each, which ends with a checksum of its bytes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from io import FileIO
from pathlib import Path

import pydantic

from probe import reading
from probe.checksum import has_sum, with_sum, without_sum
from probe.episodes.document import EpisodeDocument
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, OutputFailed
from probe.files import write_bytes

_BLOCK = 2**16
_REMEDY = (
    "If these are your own records, delete this line (the others are whole) and run the episode "
    "again"
)


def line_of(record: EpisodeRecord, *, timed: bool = True) -> bytes:
    """A record as one line of JSON; without timing, equal episodes give equal bytes."""
    return with_sum(EpisodeDocument.of(record, timed=timed).model_dump_json().encode())


def record_of(line: bytes) -> EpisodeRecord:
    """The record of a line that line_of wrote.

    Raises:
        BadData: It is no record of this version, or a byte of it has changed.
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
    rest = b""
    try:
        with reading.opened(path) as file:
            start = file.seek(0, os.SEEK_END)
            # From the end: a file of records may have gigabytes, and is looked at for each new one.
            while start and b"\n" not in rest:
                end, start = start, max(0, start - _BLOCK)
                file.seek(start)
                rest = file.read(end - start) + rest
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    return rest.rpartition(b"\n")[2]


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
        BadData: The file is missing, or a line is cut off, has changed since it was written, or is
            no record of this version.
    """
    return records_of(path, lines_of(path, whole=whole))


def records_of(path: Path, lines: Sequence[bytes]) -> list[EpisodeRecord]:
    """The records of all lines of a file, which have been read.

    Args:
        path: The file, for the message.
        lines: As lines_of gives them.

    Raises:
        BadData: A line is cut off, has changed since it was written, or is no record of this
            version.
    """
    return [_read(f"{path}, line {number}", line) for number, line in enumerate(lines, start=1)]


def lines_of(path: Path, *, whole: bool = True) -> list[bytes]:
    """The lines of a file of records as they are, without their ends; see read_records.

    Raises:
        BadData: The file can't be read.
    """
    try:
        content = reading.contents(path, reading.RECORDS)
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    return (content if whole else content[: content.rfind(b"\n") + 1]).splitlines()


def without_checksum(paths: Sequence[Path]) -> str | None:
    """What to tell of files some of whose lines have no checksum; None if all have one.

    Raises:
        BadData: A file can't be read.
    """
    lines = [line for path in paths for line in lines_of(path)]
    bare = sum(not has_sum(line) for line in lines)
    if not bare:
        return None
    where = str(paths[0]) if len(paths) == 1 else f"{len(paths)} files of records"
    return (
        f"{where}: {bare} of {len(lines)} records have no checksum, like all that were written "
        "before there were any. A byte of them that has changed may go unnoticed."
    )


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
        return EpisodeDocument.model_validate_json(without_sum(line)).record()
    except pydantic.ValidationError as error:
        first = error.errors(include_input=False)[0]
        field = ".".join(str(part) for part in first["loc"])
        reason = f"{field}: {first['msg']}" if field else first["msg"]
        raise BadData(place, reason, _REMEDY) from error
    except ValueError as error:
        raise BadData(place, str(error), _REMEDY) from error
