"""Carries what models and people said of objects over into a user's own library."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from probe.assets.annotation.notes import FIELDS, Note
from probe.assets.gltf.glb import glb_bytes, load_glb
from probe.assets.importers.reposing import reposed
from probe.assets.pools.entry import read_entry
from probe.assets.pools.own import ENTRY, MESH, replace_object
from probe.files import write_text


def apply_notes(library: Path, notes: Iterable[Note]) -> int:
    """Write the words into the entries of those objects that the library holds.

    What an object only came with stays as it is. Where a person says that the other axis points up,
    the object is laid down again.

    Returns:
        How many entries changed.

    Raises:
        BadData: An entry is broken, or an object can't stand with the axis up that is asked for.
        BadMesh: An object's mesh can't be used.
        OutputFailed: The disk is full, or the library can't be written.
    """
    return sum(_apply(library, note) for note in notes)


def _apply(library: Path, note: Note) -> bool:
    path = library / note.id / ENTRY
    told = [field for field in (*FIELDS, "mass") if note.origins.get(field, "source") != "source"]
    turned = note.up is not None and note.origins.get("up") == "human"
    if not (told or turned) or not path.is_file():
        return False
    entry = read_entry(path)
    words = {field: getattr(note, field) for field in told}
    provenance = entry.provenance | {field: note.origins[field] for field in told}
    new = entry.model_copy(update={**words, "provenance": provenance})
    if turned and note.up is not None and (note.up != entry.up or not entry.up_sure):
        mesh, new = reposed(load_glb(library / note.id / MESH), new, note.up)
        replace_object(library, new, glb_bytes(mesh, new.licence))
        return True
    if new == entry:
        return False
    write_text(path, new.model_dump_json(indent=2) + "\n")
    return True
