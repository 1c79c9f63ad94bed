"""glTF 2.0: ``.glb`` files, and ``.gltf`` with what lies beside them."""

from __future__ import annotations

from pathlib import Path
from typing import cast

import trimesh

from probe.assets.gltf.glb import read_gltf
from probe.assets.gltf.header import read_tree
from probe.assets.gltf.uris import outside_files
from probe.assets.importers.licences import spdx
from probe.assets.importers.masses import stated_mass
from probe.assets.importers.source import Importer, Source, SourceFacts, SourceFrame, sources_at
from probe.assets.importers.wording import place_of


def _find(path: Path) -> list[Source]:
    return sources_at(path, ".glb", ".gltf")


def _facts(source: Source) -> SourceFacts:
    asset: object = read_tree(source.mesh)[0].get("asset")
    stated = cast(dict[str, object], asset).get("copyright") if isinstance(asset, dict) else None
    words = stated.strip() if isinstance(stated, str) else ""
    name, home = place_of(source.mesh, source.root)
    mass, remarks = stated_mass(source.mesh, home, source.root)
    return SourceFacts(name, mass=mass, licence=spdx(words), source=words or None, remarks=remarks)


def _files(source: Source) -> tuple[Path, ...]:
    return (source.mesh, *outside_files(source.mesh, read_tree(source.mesh)[0]))


def _read(source: Source) -> trimesh.Trimesh:
    return read_gltf(source.mesh)


GLTF = Importer(_find, _facts, _files, _read, SourceFrame(1.0, "y"))
