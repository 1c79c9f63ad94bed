from __future__ import annotations

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.terrain import CELL, lifted, survey
from probe.scene.setup import UR5_TABLE
from probe.types import Frame

TALL = Block(0.12, -0.10, (0.05, 0.06, 0.15))


def heights_at(terrain, *points: tuple[float, float]) -> np.ndarray:
    return terrain.below(np.array([[x, y, 0.0] for x, y in points]))


def test_heights_are_those_of_the_blocks_and_of_the_table() -> None:
    terrain = survey(view([TALL])[0], UR5_TABLE)
    found = heights_at(terrain, (0.12, -0.10), (0.10, -0.12), (-0.2, 0.2), (0.2, 0.1))
    assert found == pytest.approx([0.15, 0.15, 0.0, 0.0], abs=0.001)


def test_the_shadow_of_a_tall_thing_is_as_low_as_what_lies_around() -> None:
    terrain = survey(view([TALL])[0], UR5_TABLE)
    # Of the table beyond the block nothing is seen for 0.15 / 1.05 of its distance, 17 mm.
    assert heights_at(terrain, (0.12 + 0.025 + 0.006, -0.10)) == pytest.approx([0.0], abs=0.001)


def test_the_basket_has_walls_and_an_empty_middle() -> None:
    terrain = survey(view([])[0], UR5_TABLE)
    x, y, _ = UR5_TABLE.basket.position
    wall = y + UR5_TABLE.basket.size[1] / 2 + 2 * CELL
    assert heights_at(terrain, (x, wall), (x, y)) == pytest.approx([UR5_TABLE.basket.size[2], 0.0])


def test_what_lies_in_the_basket_stands_as_high_as_its_camera_sees_it() -> None:
    camera = UR5_TABLE.basket_camera
    x, y, floor = camera.world_from_camera.position
    depth = np.full((camera.height_px, camera.width_px), floor, np.float32)
    depth[200:300, 200:300] -= 0.1
    terrain = survey(view([TALL])[0], UR5_TABLE, Frame(camera, depth))
    found = heights_at(terrain, (x, y), (x + 0.15, y), (0.12, -0.10))
    assert found == pytest.approx([0.1, 0.0, 0.15], abs=0.001)


def test_points_beyond_the_grid_are_over_the_table() -> None:
    terrain = survey(view([TALL])[0], UR5_TABLE)
    assert heights_at(terrain, (5.0, 5.0), (-5.0, 0.0), (0.0, -9.0)).tolist() == [0, 0, 0]


def test_lifted_points_lie_on_the_block_that_the_mask_shows() -> None:
    frame, (mask,) = view([TALL])
    points = lifted(frame, mask)
    assert len(points) == mask.sum()
    assert (points > TALL.low - 1e-4).all() and (points < TALL.high + 1e-4).all()
