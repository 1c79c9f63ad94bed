"""A table on which nothing stands but the plain box that `probe robot check` works with."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import trimesh

from probe.assets.library import Library
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body, ConvexPiece, Material, TexturedMesh
from probe.assets.spec import ObjectSpec
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import Setup
from probe.types import Pose, Vector3

_ID = "check_box"
_TABLE = "oak_planks"
_COLOUR = (200, 70, 40)
_DENSITY = 300.0
"""Kilograms in a cubic metre: a box of wood, or of cardboard with something in it."""


class BoxLibrary(Library):
    """A library that holds one plain box.

    Args:
        size: Of the box along x, y and z, metres.
        cache: Folder for what is computed of the table.
    """

    def __init__(self, size: Vector3, cache: Path) -> None:
        super().__init__((_spec(size),), None, cache)

    def body(self, object_id: str, looks: Looks = 1) -> Body:
        """Its mesh and its shape; raises UnknownName for any other id."""
        return _body(self[object_id].size)

    def form(self, object_id: str) -> Body:
        """As body(): it is plain anyway."""
        return self.body(object_id)


def box_scene(setup: Setup, seed: int) -> Scene:
    """The box upright in the middle of a table, a little beside it, as people lay things."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-0.008, 0.008, 2)
    turn = rng.uniform(-0.06, 0.06)
    pose = Pose.of(np.array([x, y, 0.0]), np.array([np.cos(turn / 2), 0.0, 0.0, np.sin(turn / 2)]))
    return Scene(seed, _TABLE, (PlacedObject(1, _ID, pose),), setup)


def _spec(size: Vector3) -> ObjectSpec:
    return ObjectSpec(
        id=_ID,
        name="plain box",
        category="box",
        colours=("red",),
        description="A plain box of known size.",
        mass=float(_DENSITY * np.prod(size)),
        friction=0.6,
        size=size,
        hollow=False,
        origin="procedural",
        licence="Apache-2.0",
        source="made here",
    )


def _body(size: Vector3) -> Body:
    shape = trimesh.creation.box(size)
    shape.apply_translation((0.0, 0.0, size[2] / 2))
    corners = np.asarray(shape.vertices, float)
    shape.unmerge_vertices()
    mesh = TexturedMesh(
        np.asarray(shape.vertices, np.float32),
        np.repeat(np.asarray(shape.face_normals), 3, axis=0).astype(np.float32),
        np.full((len(shape.vertices), 2), 0.5, np.float32),
        np.asarray(shape.faces, np.int32),
        Material(np.array([[_COLOUR]], np.uint8)),
    )
    return Body(mesh, (ConvexPiece(corners),))
