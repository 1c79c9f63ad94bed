"""Looking on changes nothing: a watched world moves as any other, to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.film.watched_world import SAMPLE_STEPS, SAMPLE_TIME, WatchedWorld
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.world.world import World

ITEMS = [box_item(1, "red box", (0.06, 0.06, 0.06)), box_item(2, "blue box", (0.05, 0.05, 0.10))]
PLACED = (
    PlacedObject(1, ITEMS[0].spec.id, at(0.1, 0.0)),
    PlacedObject(2, ITEMS[1].spec.id, at(0.1, 0.0, 0.06)),
)
SCENE = Scene(0, "grey", PLACED)


def moved(world: World, strides: list[int]) -> World:
    """Move arm and hand, and take away what the other box stands on, some steps at a time."""
    for number, stride in enumerate(strides):
        if number == len(strides) // 2:
            world.take_away(1)
        share = number / len(strides)
        away = np.array([-1.7 * share, 0.75 * min(1.0, 3 * share), 0, 0, 0, 0])
        world.command(np.array(UR5_TABLE.mount.parked) + away, np.zeros(6))
        world.command_opening(0.1 * (1 - share))
        world.step(stride)
    return world


@pytest.mark.parametrize("strides", [[1] * 600, [25] * 30, [7, 11, 50] * 12])
def test_a_watched_world_moves_as_any_other(strides: list[int]) -> None:
    plain = moved(World(SCENE, shelf(ITEMS)), strides)
    watched = moved(WatchedWorld(SCENE, shelf(ITEMS)), strides)
    assert watched.time == plain.time
    assert watched.scene() == plain.scene()
    assert watched.joints.tobytes() == plain.joints.tobytes()
    assert watched.opening == plain.opening
    assert plain.scene()[2].pose.position[2] < 0.01


def test_moments_are_evenly_spaced_and_true() -> None:
    world = WatchedWorld(SCENE, shelf(ITEMS))
    moved(world, [7, 11, 50] * 3)
    assert len(world.moments) == 1 + (68 * 3) // SAMPLE_STEPS
    times = [moment.time for moment in world.moments]
    np.testing.assert_allclose(np.diff(times), SAMPLE_TIME)
    assert world.moments[0].objects == PLACED
    last = world.moments[-1]
    assert last.time == pytest.approx(world.time)
    assert last.joints.tobytes() == world.joints.tobytes()
    assert last.opening == world.opening
