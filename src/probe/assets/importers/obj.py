"""OBJ files in any folder: named by their place, weighed by what lies beside them."""

from __future__ import annotations

from pathlib import Path

import trimesh

from probe.assets.importers.masses import stated_mass
from probe.assets.importers.source import Importer, Source, SourceFacts, SourceFrame, sources_at
from probe.assets.importers.upright import speaks_of_z
from probe.assets.importers.wavefront import ObjFiles, obj_parts, read_obj
from probe.assets.importers.wording import place_of


def _find(path: Path) -> list[Source]:
    return sources_at(path, ".obj")


def _facts(source: Source) -> SourceFacts:
    name, home = place_of(source.mesh, source.root)
    mass, remarks = stated_mass(source.mesh, home, source.root)
    remark = _parts(source).remark
    return SourceFacts(
        name,
        mass=mass,
        up="z" if speaks_of_z(home) else None,
        remarks=((remark,) if remark else ()) + remarks,
    )


def _parts(source: Source) -> ObjFiles:
    home = place_of(source.mesh, source.root)[1]
    return obj_parts(source.mesh, home, (home / "materials" / "textures",))


def _files(source: Source) -> tuple[Path, ...]:
    parts = _parts(source)
    return (source.mesh, *((parts.library,) if parts.library else ()), *parts.textures.values())


def _read(source: Source) -> trimesh.Trimesh:
    return read_obj(source.mesh, _parts(source))


OBJ = Importer(_find, _facts, _files, _read, SourceFrame(1.0, "y"), tells_up=False)
