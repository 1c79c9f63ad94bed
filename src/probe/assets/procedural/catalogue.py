"""What procedural objects there are, and each one's mesh and convex pieces."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.assets.procedural.atlas import SIDE_PX, joined, paint
from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.parts import Painted, Part
from probe.assets.procedural.tables import NEWEST_EDITION, Edition, ProceduralEntry, entries
from probe.assets.spec import ObjectSpec
from probe.errors import UnknownName
from probe.types import Array, Pose


def rng_of(name: str) -> np.random.Generator:
    """The random generator that belongs to a name, the same in every process."""
    digest = hashlib.sha256(name.encode()).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "big"))


def raw_surfaces(entry: ProceduralEntry) -> list[Painted]:
    """All surfaces of an entry's shape in the shape's own frame and size."""
    return [
        painted
        for k, part in enumerate(entry.parts)
        for painted in part.placed_surfaces(rng_of(f"{entry.shape} {k}"))
    ]


def extent(painted: list[Painted]) -> Array:
    """Size along x, y, z of the bounding box of surfaces, shape (3,)."""
    return np.ptp(_points([sheet for sheet, _ in painted]), axis=0)


def assemble(entry: ProceduralEntry) -> tuple[list[Painted], list[Array]]:
    """Surfaces and convex pieces, enlarged, resting on z = 0 and centred over the origin."""
    surfaces = [(_enlarged(sheet, entry), name) for sheet, name in raw_surfaces(entry)]
    rest = resting([sheet for sheet, _ in surfaces])
    pieces = [
        rest.apply(corners * entry.scale * np.array(entry.stretch))
        for corners in _raw_pieces(_Shape(entry.shape, entry.parts))
    ]
    return [(sheet.moved(rest), name) for sheet, name in surfaces], pieces


@dataclass(frozen=True)
class _Shape:
    """A shape by its name, which stands for its parts."""

    name: str
    parts: tuple[Part, ...] = field(compare=False)


@cache
def _raw_pieces(shape: _Shape) -> tuple[Array, ...]:
    """Convex pieces in the shape's own frame and size; its objects, often many, share them."""
    return tuple(
        corners
        for k, part in enumerate(shape.parts)
        for corners in part.placed_hulls(rng_of(f"{shape.name} {k}"))
    )


def _enlarged(sheet: Sheet, entry: ProceduralEntry) -> Sheet:
    sheet = sheet.scaled(entry.scale)
    return sheet if entry.stretch == (1, 1, 1) else sheet.stretched(np.array(entry.stretch))


def resting(sheets: list[Sheet]) -> Pose:
    """The shift that puts a shape on z = 0 with its bounding box centred over the origin."""
    points = _points(sheets)
    low, high = points.min(axis=0), points.max(axis=0)
    x, y = (float(v) for v in -(low + high)[:2] / 2)
    return Pose((x, y, -float(low[2])))


def _points(sheets: list[Sheet]) -> Array:
    return np.vstack([sheet.points.reshape(-1, 3) for sheet in sheets])


@cache
def first_of_each_shape() -> dict[str, ProceduralEntry]:
    """The first object of each shape; the others of that shape have the same parts."""
    found: dict[str, ProceduralEntry] = {}
    for entry in entries(NEWEST_EDITION).values():
        found.setdefault(entry.shape, entry)
    return found


@cache
def specs(edition: Edition) -> tuple[ObjectSpec, ...]:
    """All objects of an edition, in a fixed order; shapes are measured, no texture is drawn."""
    chosen, first = entries(edition).values(), first_of_each_shape()
    extents = {shape: extent(raw_surfaces(first[shape])) for shape in {e.shape for e in chosen}}
    return tuple(_spec(entry, extents[entry.shape]) for entry in chosen)


def build(object_id: str, looks: Looks = 1, side_px: int = SIDE_PX) -> Body:
    """Mesh and convex pieces of an object, the same bytes each time; shapes are alike in all looks.

    Args:
        object_id: Which.
        looks: How its surface looks.
        side_px: Width and height of its texture; a smaller one is drawn sooner, and its colours
            are much the same.

    Raises:
        UnknownName: No procedural object has this id.
    """
    known = entries(NEWEST_EDITION)
    if object_id not in known:
        raise UnknownName("procedural object", object_id, list(known))
    return build_entry(known[object_id], looks, side_px)


def build_entry(entry: ProceduralEntry, looks: Looks = 1, side_px: int = SIDE_PX) -> Body:
    """As build(), of an object that has been read already."""
    surfaces, pieces = assemble(entry)
    painted = [(sheet, entry.paints[name]) for sheet, name in surfaces]
    wear = None if looks == 1 else rng_of(f"{entry.id} in use")
    mesh = paint(painted, entry.roughness, entry.metallic, rng_of(entry.id), wear, side_px)
    return Body(mesh, tuple(ConvexPiece(corners) for corners in pieces))


def build_form(entry: ProceduralEntry) -> Body:
    """The shape that build() gives, unpainted: most of its time is for the texture."""
    surfaces, pieces = assemble(entry)
    mesh = joined([sheet for sheet, _ in surfaces])
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
