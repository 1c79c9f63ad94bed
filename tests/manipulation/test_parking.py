"""The arm gets home although something stands where nothing was known to be."""

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.manipulation.handshape import HandShape
from probe.manipulation.kinematics import reaching
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.parking import park
from probe.manipulation.terrain import survey
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.station.simulated import BLOCKED, SimulatedStation
from probe.types import Pose
from probe.world.world import World
from shapes import grey_table


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.mark.parametrize("y", [0.16, 0.22])
def test_what_stands_in_the_way_home_is_got_around(renderer, y) -> None:
    post = box_item(1, "tall post", (0.08, 0.08, 0.42), mass=40.0)
    there = PlacedObject(1, post.spec.id, at(0.12, y))
    renderer.load({post.spec.id: post.body.mesh}, grey_table())
    station = SimulatedStation(World(Scene(0, "grey", (there,)), shelf([post])), renderer)
    empty = survey(renderer.draw([], station.observe(rgb=False).camera, rgb=False), UR5_TABLE)
    down = Pose((0.12, 0.0, 0.28), (0.0, 1.0, 0.0, 0.0))
    start = reaching(station.arm, down, station.joints())[0]
    over = Pose((0.12, 0.0, 0.6), (0.0, 1.0, 0.0, 0.0))
    assert station.follow(np.array([reaching(station.arm, over, start)[0], start]))
    park(station, Obstacles.of(station.arm, empty), HandShape(station.hand).whole(0.1)[::3])
    assert np.abs(station.joints() - station.arm.parked).max() < BLOCKED


FOLDED = np.array([-1.041, -1.279, 2.137, -0.858, -3.061, 0.006])
"""The hand lies along the forearm; when it opens, it presses against it."""


def test_a_hand_that_opened_against_the_forearm_comes_free(renderer) -> None:
    renderer.load({}, grey_table())
    station = SimulatedStation(World(Scene(0, "grey", ()), shelf([])), renderer)
    empty = survey(renderer.draw([], station.observe(rgb=False).camera, rgb=False), UR5_TABLE)
    obstacles, hand = Obstacles.of(station.arm, empty), HandShape(station.hand)
    station.grip(0.0)
    assert station.follow(FOLDED[None])
    station.grip(0.034)
    assert not obstacles.unfolded(FOLDED, hand.whole(0.032))
    park(station, obstacles, hand.whole(0.032)[::3])
    assert np.abs(station.joints() - station.arm.parked).max() < BLOCKED
