"""Notes as a CSV table that a person corrects. Knows no pictures and no pages."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from pydantic import ValidationError

from probe.assets.annotation.notes import FIELDS, Note, said
from probe.assets.annotation.words import Described
from probe.errors import BadData
from probe.files import fault, write_text
from probe.reading import words
from probe.texts import cell, uncell

TABLE = "review.csv"
_REMEDY = "Correct that line, or delete the file to have it written anew; nothing was changed."


def write_table(path: Path, notes: Sequence[Note]) -> None:
    """Write the table: a line an object, and who said what; colours are joined by semicolons."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["id", *FIELDS, "said by", "problem"])
    for note in notes:
        by = ";".join(note.origins[field] for field in FIELDS)
        told = (note.id, note.name, note.category, ";".join(note.colours), note.description)
        table.writerow(map(cell, (*told, by, note.problem)))
    write_text(path, text.getvalue())


def corrected(path: Path, notes: Sequence[Note]) -> tuple[Note, ...]:
    """The notes with a table's corrections: a field that differs is a person's from now on.

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
        if _differs(note, line):
            known[note.id] = said(note, _words(path, number, line), "human")
    return tuple(known.values())


def _lines(path: Path, text: str) -> Iterator[tuple[int, dict[str, str]]]:
    """The lines of a table with their numbers; what a line lacks is empty."""
    reader = csv.DictReader(io.StringIO(text), restval="")
    try:
        if reader.fieldnames is None or not {"id", *FIELDS} <= set(reader.fieldnames):
            raise BadData(path, f"lacks one of the columns id, {', '.join(FIELDS)}", _REMEDY)
        for cells in reader:
            yield reader.line_num, {name: uncell(str(cells[name])) for name in ("id", *FIELDS)}
    except csv.Error as error:
        raise BadData(f"{path}:{reader.line_num}", str(error), _REMEDY) from error


def _differs(note: Note, line: Mapping[str, str]) -> bool:
    told = (note.name, note.category, ";".join(note.colours), note.description)
    return told != tuple(line[field] for field in FIELDS)


def _words(path: Path, number: int, line: Mapping[str, str | None]) -> Described:
    values: dict[str, object] = {field: line[field] for field in FIELDS}
    colours = line["colours"] or ""
    values["colours"] = tuple(word.strip() for word in colours.split(";"))
    try:
        return Described.model_validate(values)
    except ValidationError as error:
        raise BadData(f"{path}:{number}", fault(error, "the line"), _REMEDY) from error
