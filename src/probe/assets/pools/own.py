"""A user's own library: one folder an object, whole or not there."""

from __future__ import annotations

import contextlib
import os
import shutil
from pathlib import Path

from probe import reading
from probe.assets.cache import Cache, content_key
from probe.assets.collision.pieces import PIECES_VERSION, convex_pieces
from probe.assets.gltf.glb import GLB_VERSION, load_glb
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import LAYOUT, pack_body, unpack_body
from probe.assets.pools.entry import LibraryEntry, read_entry
from probe.assets.spec import ObjectSpec
from probe.errors import BadData, BadMesh, OutputFailed, UnknownName
from probe.files import whole_folder, write_bytes, write_text
from probe.reading import contents

MESH, ENTRY = "object.glb", "entry.json"
VERSION = f"{LAYOUT} {GLB_VERSION} {PIECES_VERSION}"


def own_entries(folder: Path) -> tuple[LibraryEntry, ...]:
    """Entries of all objects of a library, by id; none if there is no library yet.

    Raises:
        BadData: An entry is broken, or its id isn't its folder's name.
    """
    if not folder.is_dir():
        return ()
    homes = sorted(home for home in folder.iterdir() if not home.name.startswith("."))
    return tuple(_entry(home) for home in homes if home.is_dir())


def own_specs(folder: Path) -> tuple[ObjectSpec, ...]:
    """Specs of all objects of a library.

    Raises:
        BadData: As `own_entries`.
    """
    return tuple(entry.spec for entry in own_entries(folder))


def own_key(object_id: str, folder: Path) -> str:
    """The key of an object's body in the cache.

    Raises:
        UnknownName: The library holds no such object.
        BadData: Its entry is broken.
        BadMesh: Its mesh is missing.
    """
    home = folder / object_id
    if not home.is_dir():
        raise UnknownName("object of your own", object_id, [spec.id for spec in own_specs(folder)])
    hollow = read_entry(home / ENTRY).hollow
    return content_key("own body", VERSION, str(hollow), _bytes(home / MESH))


def own_body(object_id: str, folder: Path, cache: Cache) -> Body:
    """Mesh and convex pieces of an object of a library.

    Raises:
        UnknownName: It holds no such object.
        BadData: Its entry is broken.
        BadMesh: Its mesh is missing or can't be used.
        OutputFailed: The cache can't be written.
    """
    key, home = own_key(object_id, folder), folder / object_id
    hollow = read_entry(home / ENTRY).hollow
    stored = cache.load(key)
    if stored is not None:
        return unpack_body(stored)
    mesh = load_glb(home / MESH)
    body = Body(mesh, convex_pieces(mesh, hollow))
    if not body.pieces:
        raise BadMesh(home / MESH, "is too thin for collisions", "Give it some thickness.")
    cache.store(key, pack_body(body))
    return body


def store_object(folder: Path, entry: LibraryEntry, glb: bytes) -> None:
    """Add an object to a library: its whole folder appears at once, or not at all.

    Raises:
        OutputFailed: The disk is full, the folder can't be written, or the id is taken.
    """
    with whole_folder(folder / entry.id) as building:
        write_bytes(building / MESH, glb)
        write_text(building / ENTRY, entry.model_dump_json(indent=2) + "\n")


def replace_object(folder: Path, entry: LibraryEntry, glb: bytes) -> None:
    """Put an object in the place of the one with its id; if that fails, the old one stays.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    leaving = folder / f".leaving-{entry.id}"
    with contextlib.suppress(OSError):
        shutil.rmtree(leaving)
    try:
        os.rename(folder / entry.id, leaving)
    except OSError as error:
        raise OutputFailed(folder / entry.id, error) from error
    try:
        store_object(folder, entry, glb)
    except BaseException:
        os.rename(leaving, folder / entry.id)
        raise
    with contextlib.suppress(OSError):
        shutil.rmtree(leaving)


def remove_object(folder: Path, object_id: str) -> None:
    """Take an object out of a library, if it is there."""
    with contextlib.suppress(OSError):
        leaving = folder / f".leaving-{object_id}"
        os.rename(folder / object_id, leaving)
        shutil.rmtree(leaving)


def _entry(home: Path) -> LibraryEntry:
    entry = read_entry(home / ENTRY)
    if entry.id != home.name:
        remedy = "Give the folder that name."
        raise BadData(home / ENTRY, f"its id is {entry.id}, its folder's name {home.name}", remedy)
    return entry


def _bytes(path: Path) -> bytes:
    try:
        return contents(path, reading.MESH)
    except OSError as error:
        remedy = "Remove the object's folder and add it again."
        raise BadMesh(path, error.strerror or "can't be read", remedy) from error
