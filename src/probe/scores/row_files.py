"""Rows on disk: a table for spreadsheets and lines of JSON, both checked when they are read."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path

import pydantic

from probe.errors import BadData
from probe.files import fault, write_bytes, write_text
from probe.reading import RECORDS, contents
from probe.scores.row import Row
from probe.texts import cell, uncell

_LEFT_OUT = {"tools": "1", "necessary": ""}
"""Columns that are left out where no row says anything, and what a row has that doesn't."""

_REMEDY = "Write it again with `probe rescore`"


def write_csv(path: Path, rows: Sequence[Row]) -> None:
    """Write rows as CSV with a head (RFC 4180, UTF-8); what is unknown is an empty cell.

    There is no column for the tools if their version is 1 in all rows, as in release 0.1, and none
    for what is necessary if no task states it. A text that a spreadsheet would take for a formula
    has an apostrophe before it.

    Raises:
        OutputFailed: It can't be written; nothing half-written is left.
    """
    text = io.StringIO()
    cells = [{name: _cell(value) for name, value in row.model_dump().items()} for row in rows]
    told = {name for each in cells for name in each}
    heads = [field.alias or name for name, field in Row.model_fields.items()]
    kept = [head for head in heads if head in told or head not in _LEFT_OUT]
    unsaid = {head: rest for head, rest in _LEFT_OUT.items() if head in kept}
    writer = csv.DictWriter(text, kept)
    writer.writeheader()
    writer.writerows({**unsaid, **each} for each in cells)
    write_text(path, text.getvalue())


def read_csv(path: Path) -> list[Row]:
    """Read rows that write_csv wrote.

    Raises:
        BadData: The file is missing, isn't such a table, or a line breaks the schema.
    """
    reader = csv.DictReader(io.StringIO(_text(path)), strict=True)
    rows = list[Row]()
    try:
        for number, cells in enumerate(reader, start=1):
            known = {name: _read(each) for name, each in cells.items() if each != ""}
            rows.append(_row(f"{path}, row {number}", known))
    except csv.Error as error:
        raise BadData(path, str(error), _REMEDY) from error
    return rows


def write_json_lines(path: Path, rows: Sequence[Row]) -> None:
    """Write rows as JSON, one a line.

    Raises:
        OutputFailed: It can't be written; nothing half-written is left.
    """
    write_bytes(path, b"".join(row.model_dump_json().encode() + b"\n" for row in rows))


def read_json_lines(path: Path) -> list[Row]:
    """Read rows that write_json_lines wrote.

    Raises:
        BadData: The file is missing, or a line is cut off or breaks the schema.
    """
    text = _text(path)
    lines = text.removesuffix("\n").split("\n") if text else []
    return [_json_row(f"{path}, line {n}", line) for n, line in enumerate(lines, start=1)]


def _cell(value: object) -> object:
    if value is None:
        return ""
    if isinstance(value, str):
        return cell(value)
    return str(value).lower() if isinstance(value, bool) else value


def _read(written: object) -> object:
    """What stands in a cell; a row that is too long or too short has none or several."""
    return uncell(written) if isinstance(written, str) else written


def _text(path: Path) -> str:
    try:
        return contents(path, RECORDS).decode()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    except UnicodeDecodeError as error:
        raise BadData(path, "isn't UTF-8", _REMEDY) from error


def _row(place: str, values: object) -> Row:
    try:
        return Row.model_validate(values)
    except pydantic.ValidationError as error:
        raise BadData(place, fault(error, "the row"), _REMEDY) from error


def _json_row(place: str, line: str) -> Row:
    try:
        return Row.model_validate_json(line)
    except pydantic.ValidationError as error:
        raise BadData(place, fault(error, "the line"), _REMEDY) from error
