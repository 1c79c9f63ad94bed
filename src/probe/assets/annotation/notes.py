"""What is known of an object while it is being annotated, a file an object. Knows no model."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict

from probe.assets.annotation.words import Described
from probe.assets.importers.upright import other_axis
from probe.assets.importers.wording import described
from probe.assets.pools.entry import LibraryEntry
from probe.assets.spec import ObjectSpec
from probe.files import read_document, write_text
from probe.types import Vector3

Origin = Literal["source", "model", "human"]
"""Who says so: what the object came with, a model, or a person."""

FIELDS = ("name", "category", "colours", "description")
"""What a model is asked for."""

BY_HAND = ("mass", "up")
"""What only a person changes."""


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

    mass: float | None = None
    """Kilograms; None in notes from before this was kept."""

    mass_from: str = ""
    """Whether its files stated the mass ("source") or its words and size suggest it."""

    size: Vector3 | None = None
    up: Literal["y", "z"] | None = None
    """The file's axis that points up; None where the object's entry doesn't say."""

    other_up: Literal["y", "z"] | None = None
    """The axis that might as well point up; None if there is no doubt."""

    remarks: tuple[str, ...] = ()
    """What its user should know of how it was read."""

    @property
    def done(self) -> bool:
        """Whether a model or a person has spoken on every field."""
        return not self.problem and all(self.origins[field] != "source" for field in FIELDS)


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
        mass=spec.mass,
        size=spec.size,
    )


def from_entry(entry: LibraryEntry) -> Note:
    """What the library says of one of your own objects, and who said it."""
    note = from_source(entry.spec)
    origins = dict(note.origins)
    for field in (*FIELDS, *BY_HAND):
        said_by = entry.provenance.get(field)
        if said_by in ("model", "human"):
            origins[field] = said_by
    return note.model_copy(
        update={
            "origins": origins,
            "mass_from": entry.provenance.get("mass", ""),
            "up": entry.up,
            "other_up": other_axis(entry.up) if entry.up and not entry.up_sure else None,
            "remarks": entry.remarks,
        }
    )


def brought_up_to_date(note: Note, entry: LibraryEntry) -> Note:
    """A note with what is measured as the library has it now; what was said stays."""
    now = from_entry(entry)
    kept = {field for field in BY_HAND if note.origins.get(field) == "human"}
    fresh = {"mass", "mass_from", "size", "up", "other_up", "remarks"} - kept
    if "up" in kept:
        fresh -= {"other_up"}
    return note.model_copy(update={field: getattr(now, field) for field in fresh})


def changed_by_hand(note: Note, changes: Mapping[str, object]) -> Note:
    """A note with fields that a person changed.

    A sentence that was made of the old name is made of the new one.
    """
    if "name" in changes and note.description == described(note.name):
        changes = {"description": described(str(changes["name"])), **changes}
    origins = {**note.origins, **dict.fromkeys(changes, "human")}
    words = {"problem": ""} if set(changes) & set(FIELDS) else {}
    settled = {"other_up": None} if "up" in changes else {}
    return note.model_copy(update={**changes, **words, **settled, "origins": origins})


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
    remedy = "Delete it and annotate again; only that object is asked about again."
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
