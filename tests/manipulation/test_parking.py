"""The arm gets home although something stands where nothing was known to be."""

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.manipulation.handshape import HandShape
from probe.manipulation.kinematics import line, reaching, straight
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.parking import ArmStuck, park
from probe.manipulation.terrain import Terrain, survey
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.station.simulated import BLOCKED, SimulatedStation
from probe.types import Pose, quaternion_of
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
    came = np.array([reaching(station.arm, over, start)[0], start])
    assert station.follow(came)
    park(station, Obstacles.of(station.arm, empty), HandShape(station.hand).whole(0.1)[::3], came)
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
    park(station, obstacles, hand.whole(0.032)[::3], FOLDED[None])
    assert np.abs(station.joints() - station.arm.parked).max() < BLOCKED


ALONG_X = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
"""The hand lies level and points away from the robot."""

ELBOW_UP = np.array([-0.48, -1.05, 2.62, -1.58, 1.09, 0.0])
LEFT = box_item(1, "grey post", (0.3, 0.04, 0.30), mass=40.0)
RIGHT = box_item(2, "brown post", (0.3, 0.04, 0.30), mass=40.0)
BOARD = box_item(3, "wide board", (0.34, 0.62, 0.06), mass=80.0)
SHELF = (
    PlacedObject(1, LEFT.spec.id, at(0.2, -0.2)),
    PlacedObject(2, RIGHT.spec.id, at(0.2, 0.2)),
    PlacedObject(3, BOARD.spec.id, at(0.2, 0.0, 0.301)),
)


@pytest.fixture
def in_a_shelf(renderer):
    """An arm that has reached deep under a heavy board between posts, and how it came there."""
    items = [LEFT, RIGHT, BOARD]
    renderer.load({item.spec.id: item.body.mesh for item in items}, grey_table())
    station = SimulatedStation(World(Scene(0, "grey", SHELF), shelf(items)), renderer)
    before = Pose.of(np.array([-0.18, 0.0, 0.17]), quaternion_of(ALONG_X))
    start = min(
        reaching(station.arm, before, station.joints()),
        key=lambda joints: float(np.abs(joints - ELBOW_UP).max()),
    )
    down = straight(station.arm, start, line(before, (0.0, 0.0, 0.3)))
    inwards = straight(station.arm, start, line(before, (0.24, 0.0, 0.0)))
    assert down is not None and inwards is not None
    came = np.vstack([down[::-1], start, inwards])
    assert station.follow(came)
    return station, came


def known(renderer) -> Terrain:
    """What is known: an empty table."""
    return survey(renderer.draw([], UR5_TABLE.camera(), rgb=False), UR5_TABLE)


def test_an_arm_whose_ways_home_are_all_blocked_draws_back_as_it_came(renderer, in_a_shelf) -> None:
    station, came = in_a_shelf
    obstacles = Obstacles.of(station.arm, known(renderer))
    park(station, obstacles, HandShape(station.hand).whole(0.1)[::3], came)
    assert np.abs(station.joints() - station.arm.parked).max() < BLOCKED
    ends = [np.array(placed.pose.position) for placed in station.snapshot().objects]
    moved = [np.linalg.norm(end - it.pose.position) for end, it in zip(ends, SHELF, strict=True)]
    assert max(moved) < 0.02


def test_an_arm_that_nothing_brings_home_says_where_it_is(renderer, in_a_shelf) -> None:
    station, came = in_a_shelf
    obstacles = Obstacles.of(station.arm, known(renderer))
    with pytest.raises(
        ArmStuck, match=r"joint \d is \d\.\d\d rad short .* The hand is at x 0\.\d\d"
    ):
        park(station, obstacles, HandShape(station.hand).whole(0.1)[::3], came[-1:])
