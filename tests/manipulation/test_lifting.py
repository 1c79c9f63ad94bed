from __future__ import annotations

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.candidates import Grasp
from probe.manipulation.edges import pinches
from probe.manipulation.handshape import HandShape
from probe.manipulation.lifting import lifts
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.target import Target, target_of
from probe.manipulation.terrain import survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.station.ur5 import Ur5
from probe.types import Array

HAND = Gripper()
ARM = Ur5(UR5_TABLE.mount)
SLAB = Block(0.0, 0.02, (0.14, 0.18, 0.015), z=0.06)
STONE = Block(0.0, 0.02, (0.03, 0.03, 0.06))


def scene(*others: Block) -> tuple[Obstacles, Target, list[Grasp]]:
    """A slab on a stone among others: all but the slab, the slab, and pinches of its edges."""
    frame, masks = view((SLAB, STONE, *others))
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, masks[0], terrain)
    obstacles = Obstacles.of(ARM, terrain.without(target.cells))
    return obstacles, target, pinches(target, terrain, HAND)


def first_lift(obstacles: Obstacles, target: Target, grasp: Grasp) -> tuple[Array, Array, float]:
    """Joint angles at the grasp, those of the first way up, and its height."""
    start = ARM.inverse(grasp.hand)[0]
    points = HandShape(HAND).whole(grasp.opening)[::3]
    path, height = next(lifts(obstacles, start, grasp, target.top, points, UR5_TABLE.basket))
    return start, path, height


@pytest.fixture(scope="module")
def steep() -> tuple[Obstacles, Target, Grasp]:
    """A pinch by a hand that comes in at over 35 degrees to the slab, within the arm's reach."""
    obstacles, target, found = scene()
    chosen = [g for g in found if g.turn > np.radians(35) and ARM.inverse(g.hand)]
    assert chosen
    return obstacles, target, chosen[0]


def test_where_it_holds_goes_straight_up(steep) -> None:
    obstacles, target, grasp = steep
    start, path, height = first_lift(obstacles, target, grasp)
    held = ARM.forward(start).inverse().apply(np.array([grasp.middle]))
    places = np.array([ARM.forward(joints).apply(held)[0] for joints in path])
    assert np.allclose(places[:, :2], grasp.middle[:2], atol=1e-5)
    assert places[-1, 2] == pytest.approx(grasp.middle[2] + height, abs=1e-5)
    assert (np.diff(places[:, 2]) > 0).all()


def test_the_pads_come_to_lie_along_the_slab(steep) -> None:
    start, path, _ = first_lift(*steep)
    approach = [ARM.forward(joints).rotation[:, 2] for joints in (start, path[-1])]
    assert approach[0][2] < -0.5
    assert abs(approach[1][2]) < 0.02


def test_it_turns_only_where_there_is_room_for_the_hand(steep) -> None:
    obstacles, target, grasp = steep
    _, path, _ = first_lift(obstacles, target, grasp)
    points = HandShape(HAND).whole(grasp.opening)[::3]
    for joints in path[2:]:
        world = ARM.forward(joints).apply(points)
        assert (world[:, 2] > obstacles.terrain.below(world)).all()


def test_a_grasp_that_asks_for_no_turn_keeps_the_hand_as_it_is(steep) -> None:
    obstacles, target, grasp = steep
    straight = Grasp(grasp.hand, grasp.middle, grasp.opening, grasp.width, grasp.tilt, grasp.merit)
    start, path, _ = first_lift(obstacles, target, straight)
    for joints in path:
        turned = ARM.forward(joints).rotation.T @ ARM.forward(start).rotation
        assert np.allclose(turned, np.eye(3), atol=1e-5)
