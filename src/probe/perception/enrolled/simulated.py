"""Shows a simulated camera each object of a catalogue, as an operator would do by hand.

A picture takes longest, so it shows three objects, each alone in its part of the table.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from probe.assets.library import Library
from probe.perception.enrolled.signature import Signature, signature_of
from probe.render.illumination import AMBIENT, Illumination
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Array, Camera, Pose

_UPRIGHT = Rotation.identity()
_QUARTER = Rotation.from_euler("z", 90, degrees=True)

TURNS = ("", "x180", "x90", "y90")
"""Which sides are shown: how an object is turned from its resting pose, about an axis, degrees."""

PLACES = (-0.19, 0.0, 0.19)
"""Where objects stand in one picture, x in metres; things are longer along y there."""


def enrol_simulated(
    renderer: Renderer,
    library: Library,
    object_ids: Sequence[str],
    camera: Camera,
    table_id: str,
    light: Illumination = AMBIENT,
) -> dict[str, tuple[Signature, ...]]:
    """Signatures of objects by id, one for each of TURNS.

    Args:
        renderer: What was loaded in it is replaced.
        library: Has the objects.
        object_ids: Which.
        camera: The one that the agent will see through.
        table_id: Of the table's material; it shows in no signature.
        light: Of the pictures.
    """
    material = library.table(table_id)
    meshes = {object_id: library.body(object_id).mesh for object_id in object_ids}
    renderer.load(meshes, TableTop(material.surface, material.tile_size, UR5_TABLE.table_size))
    found: dict[str, list[Signature]] = {object_id: [] for object_id in object_ids}
    for first in range(0, len(object_ids), len(PLACES)):
        row = object_ids[first : first + len(PLACES)]
        for turn in TURNS:
            poses = [
                standing(meshes[object_id].vertices, turn, x)
                for object_id, x in zip(row, PLACES, strict=False)
            ]
            for object_id, signature in _seen(renderer, row, poses, camera, light):
                found[object_id].append(signature)
    return {object_id: tuple(views) for object_id, views in found.items()}


def standing(vertices: Array, turn: str, x: float) -> Pose:
    """An object's pose on the table, its longer side along y.

    Args:
        vertices: Of the object, metres, shape (n, 3).
        turn: As in TURNS.
        x: Where its middle is, metres.
    """
    rotation = Rotation.from_euler(turn[0], float(turn[1:]), degrees=True) if turn else _UPRIGHT
    wide, deep, _ = np.ptp(rotation.apply(vertices), axis=0)
    if wide > deep:
        rotation = _QUARTER * rotation
    turned = rotation.apply(vertices)
    low, high = turned.min(axis=0), turned.max(axis=0)
    middle = (low + high) / 2
    i, j, k, w = rotation.as_quat()
    return Pose.of(np.array([x - middle[0], -middle[1], -low[2]]), np.array([w, i, j, k]))


def _seen(
    renderer: Renderer,
    row: Sequence[str],
    poses: Sequence[Pose],
    camera: Camera,
    light: Illumination,
) -> Iterator[tuple[str, Signature]]:
    """What each object of one picture looks like; one that doesn't show is left out."""
    placed = [
        PlacedObject(number, object_id, pose)
        for number, (object_id, pose) in enumerate(zip(row, poses, strict=True), start=1)
    ]
    frame = renderer.draw(placed, camera, rgb=True, light=light)
    assert frame.labels is not None
    for item in placed:
        mask: Array = frame.labels == item.instance
        if mask.any():
            yield item.object_id, signature_of(frame, mask)
