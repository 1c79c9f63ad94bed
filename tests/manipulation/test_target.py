from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from manipulation.views import Block, view
from probe.manipulation.target import Target, target_of
from probe.manipulation.terrain import CELL, survey
from probe.scene.setup import UR5_TABLE


def seen(*blocks: Block) -> Target:
    """The first of some blocks."""
    frame, masks = view(blocks)
    return target_of(frame, masks[0], survey(frame, UR5_TABLE))


@settings(max_examples=15, deadline=None)
@given(
    x=st.floats(-0.15, 0.15),
    y=st.floats(-0.15, 0.15),
    length=st.floats(0.03, 0.15),
    height=st.floats(0.01, 0.15),
)
@example(x=0.0, y=0.09375, length=0.125, height=0.0625)
def test_walls_lie_on_the_sides_and_their_normals_point_outwards(x, y, length, height) -> None:
    block = Block(x, y, (length, 0.04, height))
    target = seen(block)
    half = np.array([length / 2, 0.02])
    local = target.walls[:, :2] - [x, y]
    outside = np.abs(local) / half
    depth = np.abs(np.abs(local) - half).min(axis=1)
    assert depth.max() < 2 * CELL
    assert np.linalg.norm(target.normals, axis=1) == pytest.approx(1.0)
    assert ((target.normals[:, :2] * local).sum(axis=1) > 0).all()
    flat = np.abs(outside[:, 0] - 1) > 0.3
    assert (np.abs(target.normals[flat, 1]) > 0.9).all()
    assert (target.walls[:, 2] < height).all() and (target.walls[:, 2] > 0).all()


def test_centre_of_a_block_is_its_middle() -> None:
    block = Block(0.05, -0.08, (0.10, 0.04, 0.06))
    assert seen(block).centre == pytest.approx([0.05, -0.08, 0.03], abs=0.003)


def test_where_a_neighbour_touches_there_is_no_wall() -> None:
    block = Block(0.0, 0.0, (0.06, 0.06, 0.05))
    taller = Block(0.06, 0.0, (0.06, 0.06, 0.08))
    walls = seen(block, taller).walls
    assert walls[:, 0].max() < 0.03 - CELL or (np.abs(walls[walls[:, 0] > 0.028, 1]) > 0.025).all()


def test_an_empty_mask_gives_an_empty_target() -> None:
    frame, _ = view([])
    target = target_of(frame, np.zeros(frame.depth.shape, bool), survey(frame, UR5_TABLE))
    assert len(target.walls) == len(target.top) == 0 and not target.cells.any()


@pytest.mark.parametrize("axis", [0, 1])
def test_where_a_thing_leaves_what_is_known_it_has_no_wall(axis: int) -> None:
    frame, masks = view([Block(0.1, 0.1, (0.06, 0.06, 0.05))])
    whole = survey(frame, UR5_TABLE)
    known = round((0.1 - float(whole.corner[axis])) / CELL)
    heights = whole.heights[:known] if axis == 0 else whole.heights[:, :known]
    target = target_of(frame, masks[0], replace(whole, heights=heights))
    facing = target.normals[:, axis]
    assert facing.min() < -0.9 and facing.max() < np.sqrt(0.5)
