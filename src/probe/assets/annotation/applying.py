"""Carries what models and people said of objects over into a user's own library."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from probe.assets.annotation.notes import FIELDS, Note
from probe.assets.entry import read_entry
from probe.assets.own_pool import ENTRY
from probe.files import write_text


def apply_notes(library: Path, notes: Iterable[Note]) -> int:
    """Write the words into the entries of those objects that the library holds.

    What an object only came with stays as it is.

    Returns:
        How many entries changed.

    Raises:
        BadData: An entry is broken.
        OutputFailed: The disk is full, or the library can't be written.
    """
    return sum(_apply(library / note.id / ENTRY, note) for note in notes)


def _apply(path: Path, note: Note) -> bool:
    told = [field for field in FIELDS if note.origins[field] != "source"]
    if not told or not path.is_file():
        return False
    entry = read_entry(path)
    words = {field: getattr(note, field) for field in told}
    provenance = entry.provenance | {field: note.origins[field] for field in told}
    new = entry.model_copy(update={**words, "provenance": provenance})
    if new == entry:
        return False
    write_text(path, new.model_dump_json(indent=2) + "\n")
    return True
