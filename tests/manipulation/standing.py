"""Things stood on a bare table before an arm, and what became of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from bodies import shelf
from probe.manipulation.grasp import GraspResult, grasp_and_remove
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE, Setup
from probe.station.simulated import SimulatedStation
from probe.types import Array, Pose
from probe.world.model import Item
from probe.world.world import World
from shapes import grey_table


def stand(
    renderer: Renderer, items: Sequence[Item], poses: Sequence[Pose], setup: Setup = UR5_TABLE
) -> SimulatedStation:
    library = shelf(items)
    placed = [
        PlacedObject(item.instance, item.spec.id, pose)
        for item, pose in zip(items, poses, strict=True)
    ]
    renderer.load({item.spec.id: item.body.mesh for item in items}, grey_table())
    return SimulatedStation(World(Scene(1, "grey", tuple(placed), setup), library), renderer)


def grasp_first(station: SimulatedStation) -> GraspResult:
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    return grasp_and_remove(station, frame, frame.labels == 1, station.snapshot().setup)


def position(station: SimulatedStation, instance: int = 1) -> Array:
    return np.array(station.snapshot()[instance].pose.position)


def is_in_basket(point: Array, setup: Setup = UR5_TABLE) -> bool:
    offset = np.abs(point - setup.basket.position)
    return bool(
        (offset[:2] < np.array(setup.basket.size[:2]) / 2).all()
        and offset[2] < setup.basket.size[2]
    )


def is_parked(station: SimulatedStation) -> bool:
    return bool(np.abs(station.joints() - station.arm.parked).max() < 0.01)
