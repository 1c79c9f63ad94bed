"""Your own objects on the page to review: notes from their entries, pictures of each."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from probe.api.resources import library_folder
from probe.assets.annotation.notes import Note, brought_up_to_date, from_entry, write_note
from probe.assets.cache import content_key
from probe.assets.gltf.glb import load_glb
from probe.assets.importers.reposing import reposed
from probe.assets.importers.upright import other_axis
from probe.assets.library import own_folder
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.pools.entry import LibraryEntry
from probe.assets.pools.own import MESH, own_entries
from probe.cli.screen import track
from probe.errors import BadData
from probe.files import encode, write_bytes, write_text
from probe.render.portraits import AROUND, GROUND, portrait
from probe.render.renderer import Renderer
from probe.types import Array, Vector3

_SIDE_PX = 448
_LOADED = 12


@dataclass(frozen=True)
class _Sitting:
    """What is drawn: an object as it lies, or as it would with its file's other axis up."""

    name: str
    mesh: TexturedMesh
    size: Vector3


def with_own(out: Path, notes: Sequence[Note]) -> tuple[Note, ...]:
    """The notes, up to date with the user's library, those of new objects added.

    Objects that have left the library leave the notes' table, too; their notes stay.

    Raises:
        BadData: There is no library, or it is broken.
        OutputFailed: The folder can't be written.
    """
    known = {note.id: note for note in notes}
    entries = own_entries(own_folder(library_folder()))
    if not entries:
        raise BadData(library_folder(), "holds no objects", "Add some: probe assets add")
    fresh = [
        brought_up_to_date(known[it.id], it) if it.id in known else from_entry(it) for it in entries
    ]
    for note in fresh:
        if note != known.get(note.id):
            write_note(out, note)
    return tuple(note for note in notes if not note.id.startswith("own_")) + tuple(fresh)


def with_twins(notes: Sequence[Note], others: Iterable[str] = ()) -> tuple[Note, ...]:
    """The notes with remarks on those whose name another object has, or another's name ends with.

    Args:
        notes: The notes.
        others: Names of what may lie beside them on a table.
    """
    names = sorted({*others, *(note.name for note in notes)})
    first: dict[str, str] = {}
    told: list[Note] = []
    for note in notes:
        remarks = list(note.remarks)
        if first.setdefault(note.name, note.id) != note.id:
            remarks.append(f"has the name of {first[note.name]}")
        if longer := next((name for name in names if name.endswith(f" {note.name}")), None):
            remarks.append(f"might be taken for a '{longer}': say more, its colour perhaps")
        told.append(note.model_copy(update={"remarks": tuple(remarks)}))
    return tuple(told)


def kept_views(out: Path, name: str, size: Vector3, renderer: Renderer) -> list[Array]:
    """The six pictures of a loaded object; one strip of them is kept for the page."""
    views = [portrait(renderer, name, size, side, _SIDE_PX) for side in AROUND]
    strip = Image.fromarray(np.concatenate(views, axis=1))
    small = strip.resize((strip.width // 2, strip.height // 2), Image.Resampling.LANCZOS)
    write_bytes(out / "pictures" / f"{name}.jpg", encode(small, "JPEG"))
    return views


def draw_own(out: Path) -> int:
    """Draw the user's objects that have no picture of how they lie now.

    Returns:
        How many.

    Raises:
        BadMesh: A mesh of the library can't be used.
        OutputFailed: The folder can't be written.
        NoGraphicsDriver: The machine has no Vulkan driver.
    """
    entries = [it for it in own_entries(own_folder(library_folder())) if not _is_drawn(out, it)]
    if not entries:
        return 0
    with Renderer() as renderer:
        for start in range(0, len(entries), _LOADED):
            some = entries[start : start + _LOADED]
            sittings = [one for entry in some for one in _sittings(entry)]
            renderer.load({one.name: one.mesh for one in sittings}, GROUND)
            for one in track(sittings, f"Pictures {start + 1} to {start + len(some)}"):
                kept_views(out, one.name, one.size, renderer)
            for entry in some:
                write_text(_stamp(out, entry), _look(entry))
    return len(entries)


def _sittings(entry: LibraryEntry) -> list[_Sitting]:
    """The object, and the way it would lie with the other axis up where that is in doubt."""
    mesh = load_glb(library_folder() / entry.id / MESH)
    found = [_Sitting(entry.id, mesh, entry.size)]
    if entry.up is not None and not entry.up_sure:
        other = other_axis(entry.up)
        try:
            laid, as_laid = reposed(mesh, entry, other)
        except BadData:
            return found
        found.append(_Sitting(f"{entry.id}.{other}", laid, as_laid.size))
    return found


def _is_drawn(out: Path, entry: LibraryEntry) -> bool:
    stamp = _stamp(out, entry)
    return stamp.is_file() and stamp.read_text("utf-8") == _look(entry)


def _stamp(out: Path, entry: LibraryEntry) -> Path:
    return out / "pictures" / f".{entry.id}.drawn"


def _look(entry: LibraryEntry) -> str:
    """What pictures of an object depend on."""
    return content_key(entry.content, str(entry.turn_wxyz), str(entry.up_sure))
