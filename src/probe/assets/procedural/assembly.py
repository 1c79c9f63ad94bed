"""An entry's parts put together, at rest on the table. Knows no textures."""

from __future__ import annotations

import hashlib

import numpy as np

from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.parts import Painted
from probe.assets.procedural.tables import ProceduralEntry
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
        for k, part in enumerate(entry.parts)
        for corners in part.placed_hulls(rng_of(f"{entry.shape} {k}"))
    ]
    return [(sheet.moved(rest), name) for sheet, name in surfaces], pieces


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
