"""Notes as a CSV table that a person corrects. Knows no pictures and no pages."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from probe.assets.annotation.notes import FIELDS, Note, changed_by_hand
from probe.assets.annotation.words import Category, Colours, Description, Name
from probe.assets.fitness import PAYLOAD
from probe.assets.importers.upright import up_doubt
from probe.errors import BadData
from probe.files import fault, write_text
from probe.reading import words
from probe.texts import cell, uncell

TABLE = "review.csv"
_COLUMNS = {"mass": "mass_kg", "up": "up"}
"""Columns of what only a person changes."""

_REMEDY = "Correct that line, or delete the file and run the command again; nothing was changed."


class Correction(BaseModel):
    """What a person may change of an object; what isn't there stays."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Name | None = None
    category: Category | None = None
    colours: Colours | None = None
    description: Description | None = None
    mass: Annotated[float, Field(gt=0, le=PAYLOAD)] | None = None
    up: Literal["y", "z"] | None = None


def write_table(path: Path, notes: Sequence[Note]) -> None:
    """Write the table: a line an object, and who said what; colours are joined by semicolons."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["id", *FIELDS, *_COLUMNS.values(), "size_cm", "said by", "problem", "remarks"])
    for note in notes:
        by = ";".join(note.origins[field] for field in FIELDS)
        size = " x ".join(f"{100 * edge:.1f}" for edge in note.size or ())
        told = (note.id, *_told(note).values(), size, by, note.problem, _remarks(note))
        table.writerow(map(cell, told))
    write_text(path, text.getvalue())


def corrected(path: Path, notes: Sequence[Note]) -> tuple[Note, ...]:
    """The notes with a table's corrections: a field that differs is a person's from now on.

    Tables written before masses and axes were in them are read, too.

    Raises:
        BadData: A line names no known object or breaks a rule; no line counts then.
    """
    known = {note.id: note for note in notes}
    try:
        text = words(path, encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, f"can't be read as UTF-8 text ({error})", _REMEDY) from error
    for number, line in _lines(path, text):
        note = known.get(line["id"])
        if note is None:
            raise BadData(f"{path}:{number}", f"no object is called {line['id']}", _REMEDY)
        changes = _changes(path, number, note, line)
        if changes:
            known[note.id] = changed_by_hand(note, changes)
    return tuple(known.values())


def _lines(path: Path, text: str) -> Iterator[tuple[int, dict[str, str]]]:
    """The lines of a table with their numbers; what a line lacks is empty."""
    reader = csv.DictReader(io.StringIO(text), restval="")
    try:
        if reader.fieldnames is None or not {"id", *FIELDS} <= set(reader.fieldnames):
            raise BadData(path, f"lacks one of the columns id, {', '.join(FIELDS)}", _REMEDY)
        known = [name for name in ("id", *FIELDS, *_COLUMNS.values()) if name in reader.fieldnames]
        for cells in reader:
            yield reader.line_num, {name: uncell(str(cells[name])) for name in known}
    except csv.Error as error:
        raise BadData(f"{path}:{reader.line_num}", str(error), _REMEDY) from error


def _told(note: Note) -> dict[str, str]:
    """What the table says of an object where a person may change it, by column."""
    words = {"name": note.name, "category": note.category, "colours": ";".join(note.colours)}
    mass = "" if note.mass is None else f"{note.mass:g}"
    return {**words, "description": note.description, "mass_kg": mass, "up": note.up or ""}


def _remarks(note: Note) -> str:
    doubt = (up_doubt(note.up),) if note.up and note.other_up else ()
    return "; ".join((*doubt, *note.remarks))


def _changes(
    path: Path, number: int, note: Note, line: Mapping[str, str | None]
) -> dict[str, object]:
    """The fields of a line that differ from the note, checked."""
    told = _told(note)
    fields = {column: field for field, column in _COLUMNS.items()} | {it: it for it in FIELDS}
    values: dict[str, object] = {
        field: line[column]
        for column, field in fields.items()
        if line.get(column, told[column]) != told[column]
    }
    if "colours" in values:
        values["colours"] = tuple(word.strip() for word in (line["colours"] or "").split(";"))
    if note.up is None and "up" in values:
        raise BadData(f"{path}:{number}", f"which axis of {note.id} was up isn't known", _REMEDY)
    try:
        return Correction.model_validate(values).model_dump(include=set(values))
    except ValidationError as error:
        raise BadData(f"{path}:{number}", fault(error, "the line"), _REMEDY) from error
