"""Check objects without adding them: fit or not, and what their collision pieces cost."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.collision.pieces import convex_pieces
from probe.assets.fitness import unfit
from probe.assets.gltf.glb import load_glb
from probe.assets.importers import IMPORTERS
from probe.assets.importers.entries import remarks_on
from probe.assets.importers.limits import limited
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.parallel import spread
from probe.assets.importers.selection import Passed, sift
from probe.assets.importers.source import Axis, Format, Source
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.resting import rest_of
from probe.assets.pools.own import MESH, own_entries
from probe.assets.pools.scan_catalogue import scan_rows
from probe.errors import BadData, BadMesh
from probe.types import Vector3


@dataclass(frozen=True)
class Imported:
    """An object as an importer would read it."""

    source: Source
    order: ImportOptions

    @property
    def label(self) -> str:
        return self.source.label


@dataclass(frozen=True)
class Catalogued:
    """An object as a pool reads it.

    Attributes:
        label: Its id.
        path: Its GLB.
        up_euler_deg: As `load_glb` takes it.
        hollow: As the catalogue says.
        mass: Kilograms.
        set_aside: Why the catalogue doesn't use it; empty if it does.
    """

    label: str
    path: Path
    up_euler_deg: Vector3
    hollow: bool
    mass: float
    set_aside: str = ""


Candidate = Imported | Catalogued


@dataclass(frozen=True)
class FitnessVerdict:
    """What a check found.

    Attributes:
        label: The object.
        refusal: Why it can't be used; None if it can.
        pieces: How many collision pieces it has.
        seconds: CPU time that they took.
        remarks: What a user should know of it.
    """

    label: str
    refusal: str | None
    pieces: int = 0
    seconds: float = 0.0
    remarks: tuple[str, ...] = ()


def candidates_at(path: Path, unit: float | None = None, up: Axis | None = None) -> list[Candidate]:
    """Everything below a folder that an importer reads; models of a set are only taken as such.

    Args:
        path: The folder, or one file.
        unit: Metres per unit; None for each format's own.
        up: The axis that points up; None for each format's own.

    Raises:
        BadData: There is nothing.
    """
    return sifted_at(path, unit, up)[0]


def sifted_at(
    path: Path, unit: float | None = None, up: Axis | None = None
) -> tuple[list[Candidate], list[Passed]]:
    """As `candidates_at`, and the meshes that are no objects of their own, with reasons."""
    found: list[tuple[Source, ImportOptions]] = []
    claimed: set[Path] = set()
    formats: tuple[Format, ...] = ("bop", "gso", "gltf", "obj")
    for format in formats if path.exists() else ():
        sources = IMPORTERS[format].find(path)
        free = [one for one in sources if not claimed & {one.mesh, *one.mesh.parents}]
        found += [(source, ImportOptions(format, unit, up)) for source in free]
        if format in ("bop", "gso"):
            claimed |= {source.root for source in free}
    if not found:
        raise BadData(path, "holds no objects in a format that we read", "See docs/how-to/import.")
    kept, passed = sift(found)
    return [Imported(source, order) for source, order in kept], passed


def scan_candidates(folder: Path) -> list[Candidate]:
    """All scans of the catalogue, in a folder of scans."""
    return [
        Catalogued(
            row.id,
            folder / f"{row.id}.glb",
            row.up,
            row.hollow,
            row.mass,
            "" if row.confirmed else f"is set aside in the catalogue: {row.why}",
        )
        for row in scan_rows()
    ]


def own_candidates(folder: Path) -> list[Candidate]:
    """All objects of a user's library."""
    return [
        Catalogued(entry.id, folder / entry.id / MESH, (0, 0, 0), entry.hollow, entry.mass)
        for entry in own_entries(folder)
    ]


def check(candidates: Sequence[Candidate], workers: int) -> Iterator[FitnessVerdict]:
    """Check objects in parallel; yields each verdict as it is known."""
    for candidate, verdict in spread(verdict_of, candidates, workers):
        yield verdict or FitnessVerdict(candidate.label, "a worker process died over it or another")


def verdict_of(candidate: Candidate) -> FitnessVerdict:
    """Check one object."""
    path = candidate.source.mesh if isinstance(candidate, Imported) else candidate.path
    try:
        with limited(path):
            mesh, hollow, refusal, remarks = _read(candidate)
            start = time.process_time()
            pieces = convex_pieces(mesh, hollow)
            seconds = time.process_time() - start
    except (BadMesh, BadData) as reason:
        return FitnessVerdict(candidate.label, str(reason))
    return FitnessVerdict(candidate.label, refusal, len(pieces), seconds, remarks)


def _read(candidate: Candidate) -> tuple[TexturedMesh, bool, str | None, tuple[str, ...]]:
    """Mesh, whether it is hollow, why it can't be used, and remarks."""
    if isinstance(candidate, Imported):
        mesh, entry = normalised(candidate.source, candidate.order)
        return mesh, entry.hollow, None, remarks_on(entry)
    mesh = load_glb(candidate.path, candidate.up_euler_deg)
    refusal = unfit(mesh.vertices, mesh.faces, rest_of(mesh.vertices), candidate.mass)
    return mesh, candidate.hollow, refusal or candidate.set_aside or None, ()
