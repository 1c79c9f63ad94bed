"""What procedural objects there are, and each one's mesh and convex pieces."""

from __future__ import annotations

from functools import cache

import numpy as np

from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.assets.procedural.assembly import assemble, extent, raw_surfaces, rng_of
from probe.assets.procedural.atlas import paint
from probe.assets.procedural.tables import ProceduralEntry, entries
from probe.assets.spec import ObjectSpec
from probe.errors import UnknownName
from probe.types import Array


@cache
def specs() -> tuple[ObjectSpec, ...]:
    """All procedural objects, in a fixed order; shapes are measured, no texture is drawn."""
    first = {entry.shape: entry for entry in entries().values()}
    extents = {shape: extent(raw_surfaces(entry)) for shape, entry in first.items()}
    return tuple(_spec(entry, extents[entry.shape]) for entry in entries().values())


def build(object_id: str) -> Body:
    """Mesh and convex pieces of an object, the same bytes each time.

    Raises:
        UnknownName: No procedural object has this id.
    """
    known = entries()
    if object_id not in known:
        raise UnknownName("procedural object", object_id, list(known))
    entry = known[object_id]
    surfaces, pieces = assemble(entry)
    looks = [(sheet, entry.paints[name]) for sheet, name in surfaces]
    mesh = paint(looks, entry.roughness, entry.metallic, rng_of(entry.id))
    return Body(mesh, tuple(ConvexPiece(corners) for corners in pieces))


def _spec(entry: ProceduralEntry, unscaled: Array) -> ObjectSpec:
    size = unscaled * entry.scale * np.array(entry.stretch)
    x, y, z = (round(float(v), 4) for v in size)
    return ObjectSpec(
        id=entry.id,
        name=entry.name,
        category=entry.category,
        colours=entry.colours,
        description=entry.description,
        mass=entry.mass,
        friction=entry.friction,
        size=(x, y, z),
        hollow=entry.hollow,
        origin="procedural",
        licence="Apache-2.0",
        source="PROBE procedural",
    )
