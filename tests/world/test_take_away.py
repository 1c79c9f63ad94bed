"""Things that vanish into the basket, and what physics makes of the rest."""

import numpy as np
import pytest

from boxes import box_library, standing
from probe.scene.setup import UR5_TABLE
from probe.tasks.grading import whereabouts
from probe.world.world import TIME_STEP, World

LIBRARY = box_library(
    low_box=(0.10, 0.10, 0.04, 200, 40, 40),
    high_box=(0.06, 0.06, 0.03, 40, 40, 200),
    long_box=(0.30, 0.10, 0.05, 40, 200, 40),
)


def stacked() -> World:
    spots = [("low_box", 0.0, 0.0, 0.0), ("high_box", 0.0, 0.0, 0.04), ("long_box", 0.0, 0.2, 0.0)]
    return World(standing(LIBRARY, *spots), LIBRARY)


def run(world: World, seconds: float = 2.0) -> None:
    world.step(round(seconds / TIME_STEP))


def moved(world: World, before: World, instance: int) -> float:
    after, was = world.scene()[instance].pose, before.scene()[instance].pose
    return float(np.linalg.norm(np.subtract(after.position, was.position)))


def test_what_stood_on_it_falls_and_the_rest_stays():
    world = stacked()
    world.take_away(1)
    run(world)
    scene = world.scene()
    assert whereabouts(scene[1].pose, UR5_TABLE) == "basket"
    assert scene[2].pose.position[2] == pytest.approx(0.0, abs=0.002)
    assert np.hypot(*scene[2].pose.position[:2]) < 0.01
    assert moved(world, stacked(), 3) == 0.0
    assert np.abs(world.joints - stacked().joints).max() < 1e-3


def test_what_lay_beneath_it_stays():
    world = stacked()
    world.take_away(2)
    run(world)
    assert moved(world, stacked(), 1) < 1e-3
    assert whereabouts(world.scene()[2].pose, UR5_TABLE) == "basket"


def test_all_of_them_find_room_in_the_basket():
    world = stacked()
    for instance in (3, 2, 1):
        world.take_away(instance)
        run(world)
    for placed in world.scene().objects:
        x, y, z = placed.pose.position
        assert np.hypot(x - UR5_TABLE.basket.position[0], y - UR5_TABLE.basket.position[1]) < 0.05
        assert 0.0 < z < 0.03
