"""What is known of an object while it is being annotated, a file an object. Knows no model."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict

from probe.assets.annotation.words import Described
from probe.assets.spec import ObjectSpec
from probe.files import read_document, write_text

Origin = Literal["source", "model", "human"]
"""Who says so: what the object came with, a model, or a person."""

FIELDS = ("name", "category", "colours", "description")


class Note(BaseModel):
    """The words on one object, who said each, and why a model said nothing."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str
    name: str
    category: str
    colours: tuple[str, ...]
    description: str
    origins: dict[str, Origin]
    problem: str = ""
    """Why the model's words are missing; empty if they aren't."""

    @property
    def done(self) -> bool:
        """Whether a model or a person has spoken on every field."""
        return not self.problem and "source" not in self.origins.values()


def from_source(spec: ObjectSpec, problem: str = "") -> Note:
    """What an object came with."""
    return Note(
        id=spec.id,
        name=spec.name,
        category=spec.category,
        colours=spec.colours,
        description=spec.description,
        origins=dict.fromkeys(FIELDS, "source"),
        problem=problem,
    )


def said(note: Note, words: Described, origin: Origin) -> Note:
    """A note with words put in by a model or a person; what a person said is never overruled."""
    changed: dict[str, object] = {}
    origins = dict(note.origins)
    for field in FIELDS:
        kept = origin == "model" and origins[field] == "human"
        same = origin == "human" and getattr(words, field) == getattr(note, field)
        if not kept and not same:
            changed[field] = getattr(words, field)
            origins[field] = origin
    return note.model_copy(update={**changed, "origins": origins, "problem": ""})


def read_note(path: Path) -> Note:
    """A note from its file.

    Raises:
        BadData: It can't be read or breaks the schema.
    """
    remedy = "Delete it and annotate again; that object alone is asked about anew."
    return read_document(path, Note, remedy, missing=remedy)


def write_note(folder: Path, note: Note) -> None:
    """Write a note whole or not at all.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    write_text(note_path(folder, note.id), note.model_dump_json(indent=1) + "\n")


def note_path(folder: Path, object_id: str) -> Path:
    """Where the note on an object lies."""
    return folder / "notes" / f"{object_id}.json"


def read_notes(folder: Path) -> tuple[Note, ...]:
    """All notes of a folder, by id.

    Raises:
        BadData: One of them is broken.
    """
    return tuple(read_note(path) for path in sorted((folder / "notes").glob("*.json")))
