"""Wavefront OBJ with its MTL: checked as text before the parser sees it."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import trimesh
from trimesh.resolvers import Resolver

from probe.assets.confined import confined
from probe.assets.gltf_tree import MAX_TRIANGLES, MAX_VERTICES
from probe.assets.importers.source import Facts, Frame, Importer, Source, sources_at
from probe.assets.pictures import check_picture
from probe.assets.shaping import joined
from probe.errors import BadMesh
from probe.reading import contents

MAX_BYTES = 2**29
MAX_WORDS = 20 * MAX_TRIANGLES
MAX_MTL_BYTES = 2**20
_MAP = re.compile(rb"^[ \t]*map_Kd[ \t]+(.+?)[ \t\r]*$", re.M)
_LIBRARY = re.compile(rb"^mtllib[ \t]+(.+?)[ \t\r]*$", re.M)
_USED = re.compile(rb"^usemtl[ \t]+(.+?)[ \t\r]*$", re.M)
_MADE = re.compile(rb"^[ \t]*newmtl[ \t]+(.+?)[ \t\r]*$", re.M)
_FACE = re.compile(rb"^f[ \t]+(.*)$", re.M)
_INDEX = re.compile(rb"[+-]?\d{1,9}")
_LISTS = ("vertex", "texture coordinate", "normal")
_STATED = re.compile(rb"^# (Vertices|Faces): (\d+)[ \t\r]*$", re.M)


@dataclass(frozen=True)
class Parts:
    """The files of an OBJ, by the names it uses for them."""

    text: bytes
    library: Path
    textures: dict[str, Path]


def obj_parts(path: Path, root: Path, texture_folders: Sequence[Path] = ()) -> Parts:
    """An OBJ's text and the files that it refers to, all checked.

    Args:
        path: The OBJ.
        root: Nothing outside is read.
        texture_folders: Where else a texture may lie than beside its MTL.

    Raises:
        BadMesh: Too large, cut off, or a material or texture is missing or lies outside.
    """
    text = _text(path, MAX_BYTES)
    _check_counts(path, text)
    _check_indices(path, text)
    named = _LIBRARY.findall(text)
    if not named:
        raise BadMesh(path, "names no material file (mtllib)", "Export it with its materials.")
    library = confined(path, _words(named[0]), path.parent, root=root)
    materials = _text(library, MAX_MTL_BYTES)
    made = set(_MADE.findall(materials))
    for used in sorted(set(_USED.findall(text)) - made):
        known = ", ".join(sorted(_words(name) for name in made)) or "nothing"
        reason = f"uses the material {_words(used)!r}, but {library.name} defines {known}"
        raise BadMesh(path, reason, "Correct the name, or export it with its materials.")
    textures: dict[str, Path] = {}
    for name in map(_words, _MAP.findall(materials)):
        found = confined(library, name, library.parent, *texture_folders, root=root)
        check_picture(path, found)
        textures[name] = found
    return Parts(text, library, textures)


def read_obj(path: Path, parts: Parts) -> trimesh.Trimesh:
    """The triangles of an OBJ, in its own frame.

    Raises:
        BadMesh: It can't be parsed, or lacks triangles, texture coordinates or a texture.
    """
    try:
        scene = trimesh.load_scene(
            io.BytesIO(parts.text), file_type="obj", resolver=_Known(parts), process=False
        )
        meshes = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as error:
        # The parser meets hostile text here and may raise anything; the cause stays attached.
        remedy = "Export the model again as OBJ with materials."
        raise BadMesh(path, f"can't be parsed ({error})", remedy) from error
    return joined(path, meshes)


class _Known(Resolver):
    """Gives the parser the files that were checked, and no others."""

    def __init__(self, parts: Parts) -> None:
        self._files = {**parts.textures, parts.library.name: parts.library}
        self._library = parts.library

    def get(self, key: str) -> bytes:
        if Path(key.replace("\\", "/")).name == self._library.name:
            return self._library.read_bytes()
        return self._files[key].read_bytes()

    def write(self, name: str, data: bytes) -> None:
        raise NotImplementedError

    def namespaced(self, namespace: str) -> _Known:
        return self

    def keys(self) -> list[str]:
        return list(self._files)


def _text(path: Path, limit: int) -> bytes:
    try:
        size = path.stat().st_size
        if size > limit:
            raise BadMesh(path, f"has {size / 2**20:,.0f} MB", "Decimate it.")
        content = contents(path, limit)
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error
    if not content.strip():
        raise BadMesh(path, "the file is empty", "Copy or download it again.")
    if b"\x00" in content:
        raise BadMesh(path, "is no text", "Copy or download it again.")
    return content


def _check_counts(path: Path, text: bytes) -> None:
    lines = b"\n" + text
    found = {"Vertices": lines.count(b"\nv "), "Faces": lines.count(b"\nf ")}
    for kind, stated in _STATED.findall(text[:4096]):
        if found[kind.decode()] < int(stated[:12]):
            reason = f"truncated: {found[kind.decode()]:,} of {int(stated[:12]):,} {kind.decode()}"
            raise BadMesh(path, f"{reason.lower()} are there", "Copy or download it again.")
    if not found["Faces"]:
        raise BadMesh(path, "contains no triangles", "Export the model's mesh, not only points.")
    large = found["Faces"] > MAX_TRIANGLES or found["Vertices"] > MAX_VERTICES
    if large or text.count(b" ") > MAX_WORDS:
        reason = f"has {found['Faces']:,} faces and {found['Vertices']:,} vertices"
        remedy = f"Decimate it to at most {MAX_TRIANGLES:,} triangles (20,000 are plenty)."
        raise BadMesh(path, reason, remedy)
    last = text[text.rstrip().rfind(b"\n") + 1 :].split()
    if last[:1] == [b"f"] and len(last) < 4:
        raise BadMesh(path, "truncated: its last face is cut off", "Copy or download it again.")


def _check_indices(path: Path, text: bytes) -> None:
    """Refuse corners that are no line of the file: 0, or beyond the last one."""
    lines = b"\n" + text
    there = lines.count(b"\nv "), lines.count(b"\nvt "), lines.count(b"\nvn ")
    for face in _FACE.finditer(text):
        for corner in face[1].split():
            for index, count, name in zip(corner.split(b"/"), there, _LISTS, strict=False):
                if index and not 0 < abs(_index(index)) <= count:
                    line = text.count(b"\n", 0, face.start()) + 1
                    reason = f"line {line} names {name} {_words(index)[:20]} of {count:,}"
                    raise BadMesh(path, reason, "Export the model again as OBJ.")


def _index(raw: bytes) -> int:
    """A number; 0, which nothing has, if it is none."""
    return int(raw) if _INDEX.fullmatch(raw) else 0


def _words(raw: bytes) -> str:
    return raw.decode("utf-8", "replace")


def _find(path: Path) -> list[Source]:
    return sources_at(path, ".obj")


def _facts(source: Source) -> Facts:
    return Facts(source.mesh.stem)


def _files(source: Source) -> tuple[Path, ...]:
    parts = obj_parts(source.mesh, source.mesh.parent)
    return (source.mesh, parts.library, *parts.textures.values())


def _read(source: Source) -> trimesh.Trimesh:
    return read_obj(source.mesh, obj_parts(source.mesh, source.mesh.parent))


OBJ = Importer(_find, _facts, _files, _read, Frame(1.0, "y"))
