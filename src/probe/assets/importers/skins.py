"""The one picture beside a mesh that names none. Knows no formats."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from probe.assets.confined import MissingFile
from probe.errors import BadMesh

SUFFIXES = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tga", ".tif", ".tiff")
_FOLDERS = ("", "textures", "texture", "materials/textures", "materials", "images")
_OTHER_MAPS = re.compile(
    r"(?:^|[^a-z])(?:normals?|nrm|nor|rough(?:ness)?|metal(?:lic|ness)?|spec(?:ular)?|bump|height|"
    r"disp(?:lacement)?|ao|occlusion|depth|mask|thumb(?:nail)?|preview|icon|render)(?:[^a-z]|$)"
)


def sole_picture(mesh: Path, root: Path, missing: MissingFile) -> Path:
    """The only base colour picture beside a mesh, or in the folders where layouts keep textures.

    Args:
        mesh: Whose texture is looked for, in its folder first, then in its object's.
        root: The object's folder; nothing outside is taken, links followed.
        missing: Why the mesh has none.

    Raises:
        BadMesh: There are several: which one is meant can't be told.
        MissingFile: There is none; `missing` itself.
    """
    for folder in _places(mesh.parent, root):
        found = [
            path for path in _pictures(folder) if path.resolve().is_relative_to(root.resolve())
        ]
        if len(found) == 1:
            return found[0]
        if found:
            names = ", ".join(path.name for path in found[:4])
            remedy = "Name one of them in the material file (map_Kd)."
            reason = f"{missing.reason}, and which of {names} it means can't be told"
            raise BadMesh(mesh, reason, remedy) from missing
    raise missing


def _places(beside: Path, root: Path) -> Iterator[Path]:
    for folder in dict.fromkeys((beside, root)):
        for name in _FOLDERS:
            yield folder / name


def _pictures(folder: Path) -> list[Path]:
    """Pictures in a folder that may be a base colour, sorted."""
    if not folder.is_dir():
        return []
    found = sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES)
    return [path for path in found if path.is_file() and not _OTHER_MAPS.search(path.stem.lower())]
