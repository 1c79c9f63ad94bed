"""With real physics."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.manipulation.kinematics import line, reaching, straight
from probe.manipulation.sweeping import pressed, swept
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.station.simulated import SimulatedStation
from probe.types import Array, Pose
from probe.world.world import World
from shapes import grey_table

BOX = box_item(1, "red box", (0.12, 0.09, 0.06), mass=0.2)
DOWN = (0.0, 1.0, 0.0, 0.0)
WAY = np.array([0.08, 0.0, 0.0])


class Held(SimulatedStation):
    """A station whose arm is held back on some of its motions."""

    refused: tuple[int, ...] = ()
    moves = 0

    def follow(self, path: Array) -> bool:
        self.moves += 1
        return self.moves not in self.refused and super().follow(path)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


def over_the_box(renderer: Renderer, height: float) -> tuple[Held, Array]:
    """The closed gripper's tips so far above the table, in the middle of the box."""
    scene = Scene(1, "grey", (PlacedObject(1, BOX.spec.id, at(0.0, 0.05)),))
    renderer.load({BOX.spec.id: BOX.body.mesh}, grey_table())
    station = Held(World(scene, shelf([BOX])), renderer)
    station.grip(0.0)
    reach = station.hand.pad_reach(0.0) + station.hand.pad_half[2]
    pose = Pose((0.0, 0.05, height + reach), DOWN)
    joints = reaching(station.arm, pose, station.joints())[0]
    above = straight(station.arm, joints, line(pose, (0.0, 0.0, 0.1)))
    assert above is not None
    assert station.follow(above[-1:]) and station.follow(joints[None])
    return station, joints


def sweep(station: Held, joints: Array) -> float:
    path = straight(station.arm, joints, line(station.arm.forward(joints), WAY))
    assert path is not None
    station.moves = 0
    return swept(station, np.vstack([joints, path]), WAY)


def hand(station: Held) -> Array:
    return np.array(station.arm.forward(station.joints()).position)


def test_pressing_from_above_takes_a_box_along(renderer: Renderer) -> None:
    station, joints = over_the_box(renderer, 0.066)
    down = pressed(station, joints)
    sent = station.arm.forward(down).position[2]
    assert 0.001 < hand(station)[2] - sent < 0.005, "it presses, but not hard"
    assert sweep(station, down) == pytest.approx(0.08, abs=0.005)
    box = np.array(station.snapshot()[1].pose.position)
    # It may slip beneath the tips, but comes most of the way.
    assert 0.04 < box[0] < 0.085
    assert box[1:] == pytest.approx([0.05, 0.0], abs=0.01)


def test_over_nothing_it_stops_before_long(renderer: Renderer) -> None:
    station, joints = over_the_box(renderer, 0.10)
    down = pressed(station, joints)
    gone = station.arm.forward(joints).position[2] - station.arm.forward(down).position[2]
    assert 0.005 < gone < 0.02


def test_what_stops_it_once_is_passed_higher(renderer: Renderer) -> None:
    station, joints = over_the_box(renderer, 0.10)
    begin = hand(station)
    station.refused = (4,)
    assert sweep(station, joints) == pytest.approx(0.08, abs=0.005)
    assert 0.01 < hand(station)[2] - begin[2] < 0.02


def test_what_always_stops_it_ends_it(renderer: Renderer) -> None:
    station, joints = over_the_box(renderer, 0.10)
    station.refused = tuple(range(3, 1000))
    assert 0.0 <= sweep(station, joints) < 0.03
