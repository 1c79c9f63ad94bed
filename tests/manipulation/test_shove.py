"""Which things are pushed before a grasp, where to, and that the fingers then get around them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from bodies import at, box_item
from manipulation.standing import grasp_first, is_in_basket, is_parked, position, stand
from manipulation.views import Block, view
from probe.manipulation.candidates import Planner, propose
from probe.manipulation.grasp import GraspResult, grasp_and_remove
from probe.manipulation.push import ALONG, Direction
from probe.manipulation.shove import _swept, emptiest, stands_free
from probe.manipulation.target import Target, target_of
from probe.manipulation.terrain import Terrain, survey
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE
from probe.station.simulated import SimulatedStation
from probe.types import Frame

BOX = Block(0.0, 0.05, (0.09, 0.05, 0.06))


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


def seen(*blocks: Block) -> tuple[Frame, Target, Terrain]:
    """The first block among the others."""
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    return frame, target_of(frame, masks[0], terrain), terrain


def ways(*blocks: Block) -> list[Direction]:
    frame, target, terrain = seen(*blocks)
    return emptiest(target, terrain, frame.camera, UR5_TABLE.basket)


def test_what_stands_on_the_table_may_be_pushed_even_where_something_touches_it() -> None:
    wall = Block(0.0, 0.05 + 0.035, (0.09, 0.02, 0.10))
    for blocks in ((BOX,), (BOX, wall)):
        _, target, terrain = seen(*blocks)
        assert stands_free(target, terrain)


@pytest.mark.parametrize(
    "others",
    [
        [Block(0.0, 0.05, (0.16, 0.12, 0.03))],
        [Block(0.0, 0.05, (0.04, 0.30, 0.02), z=0.06)],
        [Block(x, 0.05, (0.03, 0.30, 0.10)) for x in (-0.06, 0.06)]
        + [Block(0.0, 0.09, (0.09, 0.03, 0.1))],
    ],
    ids=["on another", "under another", "in a nook"],
)
def test_what_may_lie_on_others_or_beneath_them_is_left_alone(others: list[Block]) -> None:
    box = Block(BOX.x, BOX.y, BOX.size, z=0.03) if others[0].size[2] == 0.03 else BOX
    _, target, terrain = seen(box, *others)
    assert not stands_free(target, terrain)


def test_it_goes_where_least_stands() -> None:
    low, tall = Block(0.07, 0.05, (0.03, 0.2, 0.03)), Block(0.0, 0.0, (0.09, 0.03, 0.15))
    assert set(ways(BOX, low, tall)[:2]) == {"left", "up"}
    near = Block(-0.055, 0.145, (0.03, 0.03, 0.10))
    assert ways(BOX, low, tall, near) == ["left", "up", "right", "down"]


def test_it_goes_neither_out_of_the_picture_nor_into_the_basket() -> None:
    edge = UR5_TABLE.view_size / 2
    assert "right" not in ways(Block(edge - 0.07, 0.05, BOX.size))
    assert "right" in ways(Block(edge - 0.12, 0.05, BOX.size))
    basket = UR5_TABLE.basket
    wall = basket.position[0] + basket.size[0] / 2
    assert "left" not in ways(Block(wall + 0.08, -0.27, BOX.size))


def by_a_wall(renderer: Renderer) -> SimulatedStation:
    """A long box with a wall along it: no finger gets in between."""
    box = box_item(1, "red box", (0.17, 0.06, 0.035), mass=0.15)
    wall = box_item(2, "green wall", (0.24, 0.04, 0.16), mass=3.0)
    return stand(renderer, [box, wall], [at(0.0, 0.05), at(0.0, 0.05 + 0.03 + 0.004 + 0.02)])


def grasped(station: SimulatedStation, planner: Planner) -> GraspResult:
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    return grasp_and_remove(station, frame, frame.labels == 1, UR5_TABLE, [planner])


@pytest.mark.slow
def test_what_stands_by_a_wall_is_pushed_away_from_it_and_gripped(renderer: Renderer) -> None:
    station = by_a_wall(renderer)
    wall = position(station, 2)
    result = grasped(station, propose)
    assert result.plans[0].removal is None and result.plans[-1].removal is not None
    assert result.shove is not None and result.shove.direction == "down"
    assert result.shove.moved is not None and 0.02 < result.shove.moved < 0.08
    assert result.status == "removed" and is_in_basket(position(station)) and is_parked(station)
    assert position(station, 2) == pytest.approx(wall, abs=0.005)


@pytest.mark.slow
def test_the_push_is_told_even_where_no_grasp_follows(renderer: Renderer) -> None:
    station = by_a_wall(renderer)
    start = position(station)
    result = grasped(station, lambda *_: [])
    assert (result.status, result.tries, len(result.plans)) == ("no_candidate", 0, 2)
    shove, labels = result.shove, result.frame.labels
    assert shove is not None and shove.mask is not None and labels is not None
    assert (labels == 1)[shove.mask].mean() > 0.9
    assert shove.moved == pytest.approx(start[1] - position(station)[1], abs=0.01)
    assert is_parked(station)


def test_what_no_push_makes_smaller_stays_where_it_is(renderer: Renderer) -> None:
    wide = stand(renderer, [box_item(1, "red slab", (0.2, 0.2, 0.02))], [at(0.0, 0.0)])
    result = grasp_first(wide)
    assert (result.status, result.shove) == ("no_candidate", None)
    assert position(wide) == pytest.approx(np.zeros(3), abs=1e-6)


@pytest.mark.parametrize("direction", ["left", "right", "up", "down"])
def test_what_would_leave_the_grid_does_not_come_back_on_its_other_side(
    direction: Direction,
) -> None:
    cells, along = np.zeros((41, 41), bool), ALONG[direction][:2].astype(int)
    start = 20 + 17 * along
    cells[*start] = True
    passed = [start + step * along for step in range(4)]
    assert sorted(map(tuple, np.argwhere(_swept(cells, ALONG[direction])))) == sorted(
        map(tuple, passed)
    )
