"""A robot that isn't there, behind a real bridge: skills do with it what they do in simulation."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest

from bodies import at, box_item, shelf
from probe.manipulation.grasp import grasp_and_remove
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE, Setup
from probe.scene.setup_file import read_setup
from probe.station.remote import RobotStation, connected
from probe.tasks.grading import whereabouts
from probe.twin.driver import TwinDriver
from probe.twin.flaws import NO_FLAWS, Flaws
from probe.twin.serving import TwinSettings, listening, twin_of
from probe.world.model import Item

TOKEN = "a token for nobody else"
JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")
RED = box_item(1, "red box", (0.09, 0.05, 0.06), mass=0.2)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as opened:
        yield opened


def station_on(
    stack: ExitStack, renderer: Renderer, item: Item, setup: Setup, flaws: Flaws, looks: int
):
    scene = Scene(1, "oak_planks", (PlacedObject(1, item.spec.id, at(0.05, 0.05)),), setup)
    settings = TwinSettings(flaws, haste=4.0, views=("top", "front"))
    robot = stack.enter_context(twin_of(scene, shelf([item]), renderer, settings))
    address = stack.enter_context(listening(robot, TOKEN, "127.0.0.1", 0))
    client = connected(address, TOKEN)
    stack.callback(client.close)
    return RobotStation(client, setup, "front", looks=looks), robot


@pytest.mark.slow
@pytest.mark.parametrize(
    ("setup", "flaws"),
    [(UR5_TABLE, NO_FLAWS), (JACO, Flaws())],
    ids=["perfect ur5", "flawed jaco"],
)
def test_a_box_is_taken_off_the_table_over_the_bridge(stack, renderer, setup, flaws) -> None:
    station, robot = station_on(stack, renderer, RED, setup, flaws, 9 if flaws != NO_FLAWS else 1)
    frame = station.observe(rgb=True)
    assert frame.labels is None and frame.rgb is not None
    rows, columns = np.indices(frame.depth.shape)
    centres = np.column_stack([columns.ravel(), rows.ravel()]) + 0.5
    points = frame.camera.lift(centres, frame.depth.ravel())
    near = (np.abs(points[:, :2]) < 0.2).all(axis=1)
    mask = (near & (points[:, 2] > 0.02)).reshape(frame.depth.shape)
    result = grasp_and_remove(station, frame, mask, setup)
    assert result.status == "removed"
    assert isinstance(robot._driver, TwinDriver)
    scene, _ = robot._driver._body.scene()
    assert whereabouts(scene.objects[0].pose, setup) == "basket"
