"""Small physical objects that tests make for themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import trimesh

from probe.assets.library import Library
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.assets.spec import ObjectSpec
from probe.types import Pose
from probe.world.model import Item
from shapes import plain, textured


def spec_of(name: str, size, mass: float = 0.1, friction: float = 0.5) -> ObjectSpec:
    """A spec with the name's first word as colour and its last as category."""
    x, y, z = (float(v) for v in size)
    return ObjectSpec(
        id=name.replace(" ", "_"),
        name=name,
        category=name.split()[-1],
        colours=(name.split()[0],),
        description=f"A {name}.",
        mass=mass,
        friction=friction,
        size=(x, y, z),
        hollow=False,
        origin="procedural",
        licence="Apache-2.0",
        source="test",
    )


def solid(shape: trimesh.Trimesh, *colour: int) -> Body:
    """A convex body resting on z = 0."""
    shape = shape.copy()
    shape.apply_translation((0, 0, -shape.bounds[0, 2]))
    mesh = textured(shape, plain(*(colour or (180, 60, 40))))
    return Body(mesh, (ConvexPiece(np.asarray(shape.vertices, float)),))


def box_item(instance: int, name: str, size, mass: float = 0.1) -> Item:
    """A box as an item."""
    return Item(instance, spec_of(name, size, mass), solid(trimesh.creation.box(size)))


def ball_item(instance: int, name: str, radius: float, mass: float = 0.1) -> Item:
    """A ball as an item."""
    shape = trimesh.creation.icosphere(2, radius)
    return Item(instance, spec_of(name, [2 * radius] * 3, mass), solid(shape))


def at(x: float, y: float, z: float = 0.0) -> Pose:
    """An upright pose."""
    return Pose((x, y, z))


@dataclass(frozen=True, eq=False)
class _Shelf(Library):
    """A library of a test's own items."""

    held: Mapping[str, Body] = field(default_factory=dict[str, Body])

    def body(self, object_id: str, looks: Looks = 1) -> Body:
        return self.held[object_id]

    def form(self, object_id: str) -> Body:
        return self.held[object_id]


_CACHE = Path(__file__).resolve().parents[1] / ".cache" / "probe"


def shelf(items: Sequence[Item]) -> Library:
    """A library that holds these items and nothing else."""
    held = {item.spec.id: item.body for item in items}
    return _Shelf(tuple(item.spec for item in items), None, _CACHE, held=held)
