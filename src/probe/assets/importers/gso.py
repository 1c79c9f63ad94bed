"""Google Scanned Objects as Gazebo's Fuel server hands them out: a folder an object."""

from __future__ import annotations

import math
import re
from pathlib import Path

import trimesh

from probe.assets.confined import confined
from probe.assets.importers.licences import spdx
from probe.assets.importers.mass_trees import parsed
from probe.assets.importers.masses import stated_mass
from probe.assets.importers.source import Importer, Source, SourceFacts, SourceFrame
from probe.assets.importers.wavefront import ObjFiles, obj_parts, read_obj
from probe.errors import BadMesh
from probe.reading import opened

MAX_TEXT_BYTES = 2**20
TEXTURES = Path("materials") / "textures"
DATA_SET = "Google Scanned Objects"
_SCHEME = re.compile(r"^model://[^/]+/")
_CATEGORY = re.compile(r'^\s*(?:first|second)\s*:\s*"([^"]+)"', re.M)
_VAGUE = {"none", "consumer goods"}


def _find(path: Path) -> list[Source]:
    """Every folder with a ``model.sdf`` below a folder, or that folder itself.

    Copies of the set inside other projects leave that file out; there, ``meshes/model.obj`` beside
    ``materials/textures`` counts.
    """
    told = {file.parent: file for file in path.rglob("model.sdf")}
    bare = {
        file.parents[1]: file
        for file in path.rglob("meshes/model.obj")
        if (file.parents[1] / TEXTURES).is_dir()
    }
    return [
        Source(str(folder.relative_to(path)), file, folder)
        for folder, file in sorted((bare | told).items())
    ]


def _facts(source: Source) -> SourceFacts:
    folder = source.root.resolve()
    text = _text(source.mesh) if _is_told(source) else ""
    notes = folder / "metadata.pbtxt"
    about = _text(notes) if notes.is_file() else ""
    categories = [name.lower() for name in _CATEGORY.findall(about)]
    mass, remarks = _mass(source), ()
    if not _is_told(source):
        mass, remarks = stated_mass(source.mesh, source.root, source.root)
    remark = _parts(source)[1].remark
    return SourceFacts(
        name=folder.name,
        category=next((name for name in categories if name not in _VAGUE), None),
        mass=mass,
        licence=spdx(text) or spdx(about),
        source=f"{DATA_SET}, {folder.name}",
        remarks=((remark,) if remark else ()) + remarks,
    )


def _is_told(source: Source) -> bool:
    return source.mesh.name == "model.sdf"


def _mass(source: Source) -> float | None:
    found = parsed(source.mesh).find(".//inertial/mass") if _is_told(source) else None
    try:
        mass = None if found is None else float(found.text or "")
    except ValueError as error:
        raise BadMesh(source.mesh, "its mass is no number", "Correct it.") from error
    if mass is not None and not (math.isfinite(mass) and mass > 0):
        raise BadMesh(source.mesh, f"its mass is {mass} kg", "Correct it.")
    return mass


def _parts(source: Source) -> tuple[Path, ObjFiles]:
    """The OBJ that the model shows, and its files.

    The OBJ's material says ``texture.png``, which is not beside it but in
    ``materials/textures``: Gazebo looks there, and so do we.
    """
    folder, obj = source.root, source.mesh
    if _is_told(source):
        uri = parsed(source.mesh).findtext(".//visual//mesh/uri") or ""
        if not uri:
            raise BadMesh(source.mesh, "shows no mesh", "Download the folder again.")
        obj = confined(source.mesh, _SCHEME.sub("", uri.strip()), folder)
    return obj, obj_parts(obj, folder, (folder / TEXTURES,))


def _files(source: Source) -> tuple[Path, ...]:
    obj, parts = _parts(source)
    library = (parts.library,) if parts.library else ()
    told = (source.mesh,) if _is_told(source) else ()
    return (obj, *library, *parts.textures.values(), *told)


def _read(source: Source) -> trimesh.Trimesh:
    return read_obj(*_parts(source))


def _text(path: Path) -> str:
    try:
        with opened(path) as file:
            return file.read(MAX_TEXT_BYTES).decode("utf-8", "replace").lstrip()
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error


GSO = Importer(_find, _facts, _files, _read, SourceFrame(1.0, "z"))
