"""The world in motion: exact save and restore, and nothing moves unless it is touched."""

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.world.world import World


@pytest.fixture
def world():
    items = [
        box_item(1, "red box", (0.06, 0.06, 0.06)),
        box_item(2, "blue box", (0.05, 0.05, 0.10)),
        box_item(3, "green box", (0.08, 0.04, 0.03)),
    ]
    poses = [at(0.1, 0.0), at(0.1, 0.0, 0.06), at(-0.15, 0.1)]
    objects = tuple(
        PlacedObject(item.instance, item.spec.id, pose)
        for item, pose in zip(items, poses, strict=True)
    )
    return World(Scene(0, "grey", objects), shelf(items))


def swing(world: World, steps: int) -> None:
    """Sweep the arm down and across the table."""
    for step in range(steps):
        away = np.array([-1.7 * step / steps, 0.75 * min(1, 3 * step / steps), 0, 0, 0, 0])
        world.command(np.array(UR5_TABLE.mount.parked) + away, np.zeros(6))
        world.step()


def test_untouched_objects_stay_to_the_bit(world):
    before = world.scene()
    world.step(1000)
    assert world.scene() == before


def test_a_tall_thing_begins_asleep_too():
    # As tall as the outstretched arm is high: the engine warns of what it can't put to sleep.
    post = box_item(1, "tall post", (0.1, 0.1, 0.4))
    there = PlacedObject(1, post.spec.id, at(0.0, 0.1))
    world = World(Scene(0, "grey", (there,)), shelf([post]))
    world.step(100)
    assert world.scene().objects == (there,)


@pytest.mark.parametrize("steps", [0, 300, 700])
def test_restoring_gives_the_same_future_to_the_bit(world, steps):
    swing(world, steps)
    saved = world.save()
    start = world.scene()
    swing(world, 700)
    first = world.scene(), world.joints.tobytes(), world.time
    swing(world, 200)
    world.restore(saved)
    assert world.scene() == start
    swing(world, 700)
    assert (world.scene(), world.joints.tobytes(), world.time) == first


def test_the_arm_moves_what_it_touches(world):
    before = world.scene()
    swing(world, 900)
    moved = [
        np.linalg.norm(np.subtract(new.pose.position, old.pose.position))
        for new, old in zip(world.scene().objects, before.objects, strict=True)
    ]
    assert max(moved) > 0.01


def test_the_gripper_opens_and_closes(world):
    for metres in (0.03, 0.12):
        world.command_opening(metres)
        world.step(500)
        assert world.opening == pytest.approx(metres, abs=0.001)
