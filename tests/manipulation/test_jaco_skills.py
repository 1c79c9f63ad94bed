"""Both skills with the Jaco, with real physics, by what either camera shows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from bodies import at, box_item
from manipulation.standing import grasp_first, is_in_basket, is_parked, position, stand
from probe.manipulation.grasp import grasp_and_remove
from probe.manipulation.push import push
from probe.render.renderer import Renderer
from probe.scene.setup_file import read_setup
from probe.station.simulated import SimulatedStation

SETUP = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")
RED = box_item(1, "red box", (0.09, 0.05, 0.06), mass=0.2)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


@pytest.mark.slow
@pytest.mark.parametrize(("x", "y"), [(-0.17, -0.15), (0.17, 0.17)])
def test_a_box_ends_in_the_basket_and_the_arm_is_parked(renderer, x: float, y: float) -> None:
    station = stand(renderer, [RED], [at(x, y)], SETUP)
    result = grasp_first(station)
    assert result.status == "removed" and result.tries == 1
    assert is_in_basket(position(station), SETUP) and is_parked(station)
    assert min(abs(result.width - side) for side in (0.05, 0.09)) < 0.005


@pytest.mark.slow
def test_what_the_front_camera_shows_is_grasped(renderer: Renderer) -> None:
    world = stand(renderer, [RED], [at(0.05, 0.08)], SETUP)._world
    station = SimulatedStation(world, renderer, SETUP.camera("front"))
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = grasp_and_remove(station, frame, frame.labels == 1, SETUP)
    assert result.status == "removed"
    assert is_in_basket(position(station), SETUP) and is_parked(station)


def test_what_is_too_wide_for_its_hand_is_left_alone(renderer: Renderer) -> None:
    # The 2F-140 would get around it.
    slab = box_item(1, "red slab", (0.12, 0.12, 0.02))
    station = stand(renderer, [slab], [at(0.0, 0.0)], SETUP)
    result = grasp_first(station)
    assert (result.status, result.tries, result.candidates) == ("no_candidate", 0, 0)
    assert position(station) == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)


class Stuck(SimulatedStation):
    """A station whose arm is held back on some of its motions."""

    moves = 0

    def follow(self, path) -> bool:
        self.moves += 1
        return self.moves % 5 != 2 and super().follow(path)


@pytest.mark.slow
def test_an_arm_that_is_stopped_goes_home_and_says_so(renderer: Renderer) -> None:
    station = Stuck(stand(renderer, [RED], [at(0.0, 0.0)], SETUP)._world, renderer)
    assert grasp_first(station).status == "blocked"
    assert is_parked(station)
    assert position(station) == pytest.approx([0.0, 0.0, 0.0], abs=0.005)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("direction", "along"),
    [("left", (-1, 0)), ("up", (0, 1))],
)
def test_a_box_goes_as_far_as_it_is_pushed(renderer, direction, along) -> None:
    station = stand(renderer, [RED], [at(0.02, 0.05)], SETUP)
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = push(station, frame, frame.labels == 1, direction, 0.1, SETUP)
    assert result.status == "pushed" and is_parked(station)
    way = position(station)[:2] - [0.02, 0.05]
    assert way @ np.array(along) == pytest.approx(0.1, abs=0.01)
    assert result.swept == pytest.approx(0.1, abs=0.008)
