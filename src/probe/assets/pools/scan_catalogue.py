"""The catalogue of real scans: our annotations, and where their files and licences come from."""

from __future__ import annotations

import csv
import io
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from probe.errors import BadData
from probe.reading import words
from probe.types import Vector3

CATALOGUE = "scans.csv"
Row = TypeVar("Row", bound=BaseModel)


def _split(value: Any) -> Any:
    return value.split(";") if isinstance(value, str) else value


class ScanRow(BaseModel):
    """One line of ``data/scans.csv``; its README says what the columns mean."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str = Field(pattern=r"^[a-z0-9_]+$")
    name: str = Field(min_length=1)
    category: str = Field(min_length=1)
    colours: Annotated[tuple[str, ...], BeforeValidator(_split)] = Field(min_length=1, max_length=3)
    description: str = Field(min_length=1)
    mass: float = Field(gt=0, le=5)
    friction: float = Field(ge=0.05, le=1.5)
    hollow: bool
    shape: str
    up: Annotated[Vector3, BeforeValidator(_split)]
    confirmed: bool
    cover: bool
    hideable: bool
    why: str


class SourceRow(BaseModel):
    """What we read of a line of ``index.csv`` in the folder of scans."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    id: str
    licence: str = Field(min_length=1)
    source_dataset: str = Field(min_length=1)


def scan_rows() -> tuple[ScanRow, ...]:
    """All annotated scans, fit for use or not.

    Raises:
        BadData: A line breaks the schema, or an id or a confirmed name is there twice.
    """
    text = (files("probe.assets") / "data" / CATALOGUE).read_text("utf-8")
    return parse_scans(text, CATALOGUE)


def parse_scans(text: str, path: object) -> tuple[ScanRow, ...]:
    """Rows of a catalogue's text; `path` is for messages.

    Raises:
        BadData: As `scan_rows`.
    """
    rows = parsed_rows(text, path, ScanRow)
    _refuse_twins(path, "id", [row.id for row in rows])
    _refuse_twins(path, "name", [row.name for row in rows if row.confirmed])
    return tuple(rows)


def scan_sources(folder: Path) -> dict[str, SourceRow]:
    """Licence and source of each scan by id, from the ``index.csv`` of the folder of scans.

    Raises:
        BadData: It isn't there or can't be read.
    """
    path = folder / "index.csv"
    try:
        text = words(path)
    except (OSError, UnicodeDecodeError) as error:
        needed = "PROBE_ASSETS has to name a folder with scans/index.csv and scans/*.glb"
        remedy = f"{needed}; `probe assets fetch v1-scans` gets them."
        raise BadData(path, f"can't be read ({error})", remedy) from error
    return {row.id: row for row in parsed_rows(text, path, SourceRow)}


def parsed_rows(text: str, path: object, kind: type[Row]) -> list[Row]:
    """Lines of a table; `path` is for messages.

    Raises:
        BadData: A line breaks the schema.
    """
    reader = csv.DictReader(io.StringIO(text), strict=True)
    rows: list[Row] = []
    try:
        for raw in reader:
            rows.append(kind.model_validate(raw))
    except ValidationError as error:
        first = error.errors()[0]
        field = ".".join(str(part) for part in first["loc"]) or "line"
        reason = f"line {reader.line_num}, {field}: {first['msg']} (got {first['input']!r})"
        raise BadData(path, reason, "Correct that line.") from error
    except csv.Error as error:
        raise BadData(path, f"line {reader.line_num}: {error}", "Correct that line.") from error
    return rows


def _refuse_twins(path: object, field: str, values: list[str]) -> None:
    twins = sorted({value for value in values if values.count(value) > 1})
    if twins:
        raise BadData(path, f"{field} {twins[0]!r} is there twice", "Rename one of the two.")
