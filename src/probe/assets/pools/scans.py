"""Specs and bodies of the scans that are fit for use, through the cache."""

from __future__ import annotations

from functools import cache as memo
from pathlib import Path

from probe.assets.cache import Cache, content_key
from probe.assets.collision.pieces import PIECES_VERSION, convex_pieces
from probe.assets.gltf.glb import GLB_VERSION, load_glb, measure_glb
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import LAYOUT, pack_body, pack_specs, unpack_body, unpack_specs
from probe.assets.pools.scan_catalogue import ScanRow, SourceRow, scan_rows, scan_sources
from probe.assets.spec import ObjectSpec
from probe.errors import BadData, BadMesh, UnknownName
from probe.reading import MESH, contents

FETCH_THEM = "`probe assets fetch v1-scans` gets the scans."
"""What to do where scans are missing."""

VERSION = f"{LAYOUT} {GLB_VERSION} {PIECES_VERSION}"


def scan_specs(folder: Path, cache: Cache) -> tuple[ObjectSpec, ...]:
    """Specs of all confirmed scans, their sizes measured from the files.

    Raises:
        BadData: A catalogue is broken.
        BadMesh: A scan's file is missing or can't be used.
    """
    rows, sources = _confirmed(), scan_sources(folder)
    parts = [row.model_dump_json().encode() + _bytes(folder, row.id) for row in rows.values()]
    key = content_key("scan specs", VERSION, repr(sorted(sources.items())), *parts)
    stored = cache.load(key)
    specs = None if stored is None else unpack_specs(stored)
    if specs is None:
        specs = tuple(_spec(row, sources, folder) for row in rows.values())
        cache.store(key, pack_specs(specs))
    return specs


def scan_key(object_id: str, folder: Path) -> str:
    """The key of a confirmed scan's body in the cache.

    Raises:
        UnknownName: No confirmed scan has this id.
        BadMesh: Its file can't be read.
    """
    rows = _confirmed()
    if object_id not in rows:
        raise UnknownName("scan", object_id, list(rows))
    row = rows[object_id]
    return content_key("scan body", VERSION, f"{row.up} {row.hollow}", _bytes(folder, object_id))


def scan_body(object_id: str, folder: Path, cache: Cache) -> Body:
    """Mesh and convex pieces of a confirmed scan.

    Raises:
        UnknownName: No confirmed scan has this id.
        BadMesh: Its file can't be used.
        OutputFailed: The cache can't be written.
    """
    key, row = scan_key(object_id, folder), _confirmed()[object_id]
    stored = cache.load(key)
    if stored is not None:
        return unpack_body(stored)
    mesh = load_glb(_path(folder, object_id), row.up)
    body = Body(mesh, convex_pieces(mesh, row.hollow))
    cache.store(key, pack_body(body))
    return body


def is_scan(object_id: str) -> bool:
    """Whether an object is one of the confirmed scans."""
    return object_id in _confirmed()


@memo
def _confirmed() -> dict[str, ScanRow]:
    return {row.id: row for row in scan_rows() if row.confirmed}


def _spec(row: ScanRow, sources: dict[str, SourceRow], folder: Path) -> ObjectSpec:
    if row.id not in sources:
        remedy = "Add its licence and source there."
        raise BadData(folder / "index.csv", f"says nothing of {row.id}", remedy)
    x, y, z = measure_glb(_path(folder, row.id), row.up)
    return ObjectSpec(
        id=row.id,
        name=row.name,
        category=row.category,
        colours=row.colours,
        description=row.description,
        mass=row.mass,
        friction=row.friction,
        size=(round(x, 4), round(y, 4), round(z, 4)),
        hollow=row.hollow,
        origin="scan",
        licence=sources[row.id].licence,
        source=sources[row.id].source_dataset,
    )


def _path(folder: Path, object_id: str) -> Path:
    return folder / f"{object_id}.glb"


def _bytes(folder: Path, object_id: str) -> bytes:
    path = _path(folder, object_id)
    try:
        return contents(path, MESH)
    except OSError as error:
        remedy = f"The folder of scans is incomplete: {FETCH_THEM}"
        raise BadMesh(path, error.strerror or "can't be read", remedy) from error
