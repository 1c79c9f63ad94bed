"""Google Scanned Objects as Gazebo's Fuel server hands them out: a folder an object."""

from __future__ import annotations

import math
import re
from pathlib import Path
from xml.etree import ElementTree

import trimesh

from probe.assets.confined import confined
from probe.assets.importers.licences import spdx
from probe.assets.importers.source import Facts, Frame, Importer, Source
from probe.assets.importers.wavefront import Parts, obj_parts, read_obj
from probe.errors import BadMesh
from probe.reading import opened

MAX_TEXT_BYTES = 2**20
DATA_SET = "Google Scanned Objects"
_SCHEME = re.compile(r"^model://[^/]+/")
_CATEGORY = re.compile(r'^\s*(?:first|second)\s*:\s*"([^"]+)"', re.M)
_VAGUE = {"none", "consumer goods"}
_DOCTYPE = re.compile(r"<!(DOCTYPE|ENTITY)", re.I)


def _find(path: Path) -> list[Source]:
    """Every folder with a ``model.sdf`` below a folder, or that folder itself."""
    found = sorted(file.parent for file in path.rglob("model.sdf"))
    return [Source(str(folder.relative_to(path)), folder / "model.sdf", folder) for folder in found]


def _facts(source: Source) -> Facts:
    folder = source.root.resolve()
    text = _text(source.mesh)
    notes = folder / "metadata.pbtxt"
    about = _text(notes) if notes.is_file() else ""
    categories = [name.lower() for name in _CATEGORY.findall(about)]
    found = _tree(source.mesh, text).find(".//inertial/mass")
    try:
        mass = None if found is None else float(found.text or "")
    except ValueError as error:
        raise BadMesh(source.mesh, "its mass is no number", "Correct it.") from error
    if mass is not None and not (math.isfinite(mass) and mass > 0):
        raise BadMesh(source.mesh, f"its mass is {mass} kg", "Correct it.")
    return Facts(
        name=folder.name,
        category=next((name for name in categories if name not in _VAGUE), None),
        mass=mass,
        licence=spdx(text) or spdx(about),
        source=f"{DATA_SET}, {folder.name}",
    )


def _parts(source: Source) -> tuple[Path, Parts]:
    """The OBJ that the model shows, and its files.

    The OBJ's material says ``texture.png``, which is not beside it but in
    ``materials/textures``: Gazebo looks there, and so do we.
    """
    uri = _tree(source.mesh, _text(source.mesh)).findtext(".//visual//mesh/uri") or ""
    if not uri:
        raise BadMesh(source.mesh, "shows no mesh", "Download the folder again.")
    folder = source.root
    obj = confined(source.mesh, _SCHEME.sub("", uri.strip()), folder)
    return obj, obj_parts(obj, folder, (folder / "materials" / "textures",))


def _files(source: Source) -> tuple[Path, ...]:
    obj, parts = _parts(source)
    return (obj, parts.library, *parts.textures.values(), source.mesh)


def _read(source: Source) -> trimesh.Trimesh:
    return read_obj(*_parts(source))


def _tree(path: Path, text: str) -> ElementTree.Element:
    # Entities are how XML explodes; no model has any.
    if _DOCTYPE.search(text):
        raise BadMesh(path, "defines entities", "Download the folder again.")
    try:
        return ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise BadMesh(path, f"is no XML ({error})", "Download the folder again.") from error


def _text(path: Path) -> str:
    try:
        with opened(path) as file:
            return file.read(MAX_TEXT_BYTES).decode("utf-8", "replace").lstrip()
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error


GSO = Importer(_find, _facts, _files, _read, Frame(1.0, "z"))
