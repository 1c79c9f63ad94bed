"""Wavefront OBJ with its MTL: checked as text before the parser sees it."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import trimesh
from trimesh.resolvers import Resolver

from probe.assets.confined import MissingFile, confined
from probe.assets.importers.obj_numbers import check_counts, check_indices
from probe.assets.importers.skins import sole_picture
from probe.assets.mesh.shaping import joined
from probe.assets.pictures import check_picture
from probe.errors import BadMesh
from probe.reading import contents

MAX_BYTES = 2**29
MAX_MTL_BYTES = 2**20
_MAP = re.compile(rb"^[ \t]*map_Kd[ \t]+(.+?)[ \t\r]*$", re.M)
_LIBRARY = re.compile(rb"^mtllib[ \t]+(.+?)[ \t\r]*$", re.M)
_USED = re.compile(rb"^usemtl[ \t]+(.+?)[ \t\r]*$", re.M)
_MADE = re.compile(rb"^[ \t]*newmtl[ \t]+(.+?)[ \t\r]*$", re.M)
_SPOKEN = re.compile(rb"^(?:mtllib|usemtl)\b.*$", re.M)
_STAND_IN, _SKIN = "stand-in.mtl", "skin"
_HEADING = b"mtllib stand-in.mtl\nusemtl skin\n"
_MATERIAL = b"newmtl skin\nmap_Kd skin\n"
"""What takes the place of materials where one picture lies beside an OBJ."""


@dataclass(frozen=True)
class ObjFiles:
    """The files of an OBJ, by the names it uses for them.

    Attributes:
        text: The OBJ.
        library: Its material file; None where a picture stands in for it.
        textures: By their names.
        remark: Which picture stands in for what the OBJ doesn't name, or names in vain.
    """

    text: bytes
    library: Path | None
    textures: dict[str, Path]
    remark: str = ""


def obj_parts(path: Path, root: Path, texture_folders: Sequence[Path] = ()) -> ObjFiles:
    """An OBJ's text and the files that it refers to, all checked.

    Args:
        path: The OBJ.
        root: Nothing outside is read.
        texture_folders: Where else a texture may lie than beside its MTL.

    Raises:
        BadMesh: Too large, cut off, or a material or texture is missing or lies outside.
    """
    text = _text(path, MAX_BYTES)
    check_counts(path, text)
    check_indices(path, text)
    try:
        return _named_parts(path, text, root, texture_folders)
    except MissingFile as missing:
        skin = sole_picture(path, root, missing)
        check_picture(path, skin)
        text = _SPOKEN.sub(b"", text)
        remark = f"{missing.reason}: {skin.name}, the only picture beside it, is used"
        return ObjFiles(_HEADING + text, None, {_SKIN: skin}, remark)


def _named_parts(path: Path, text: bytes, root: Path, texture_folders: Sequence[Path]) -> ObjFiles:
    """What an OBJ names, all of it there.

    Raises:
        BadMesh: A material isn't defined, or a file lies outside.
        MissingFile: A file isn't there, or no material file is named.
    """
    named = _LIBRARY.findall(text)
    if not named:
        reason = "names no material file (mtllib)"
        raise MissingFile(path, reason, "Export it with its materials.")
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
    return ObjFiles(text, library, textures)


def read_obj(path: Path, parts: ObjFiles) -> trimesh.Trimesh:
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

    def __init__(self, parts: ObjFiles) -> None:
        self._files = dict(parts.textures)
        self._library = parts.library

    def get(self, key: str) -> bytes:
        if self._library is None and key == _STAND_IN:
            return _MATERIAL
        if self._library and Path(key.replace("\\", "/")).name == self._library.name:
            return self._library.read_bytes()
        return self._files[key].read_bytes()

    def write(self, name: str, data: bytes) -> None:
        raise NotImplementedError

    def namespaced(self, namespace: str) -> _Known:
        return self

    def keys(self) -> list[str]:
        return [*self._files, self._library.name if self._library else _STAND_IN]


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


def _words(raw: bytes) -> str:
    return raw.decode("utf-8", "replace")
