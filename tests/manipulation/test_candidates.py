from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.candidates import Grasp, propose
from probe.manipulation.target import target_of
from probe.manipulation.terrain import lifted, survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.types import Array

HAND = Gripper()
BOX = Block(0.02, 0.05, (0.09, 0.05, 0.06))
NEIGHBOURS = (Block(0.02, 0.12, (0.10, 0.04, 0.09)), Block(-0.07, 0.04, (0.03, 0.08, 0.12)))


@cache
def grasps_of(*blocks: Block) -> list[Grasp]:
    """Grasps of the first block among the others."""
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    return propose(target_of(frame, masks[0], terrain), terrain, HAND)


def inside_hand(grasp: Grasp, points: Array, back: float = 0.0) -> Array:
    """Which points lie inside the open hand when it is still so far back."""
    local = grasp.hand.inverse().apply(points) + [0.0, 0.0, back]
    hit = np.zeros(len(points), bool)
    for centre, half in HAND.boxes(grasp.opening):
        hit |= (np.abs(local - centre) < half).all(axis=1)
    return hit


def test_a_free_box_is_held_across_its_shorter_side() -> None:
    best = grasps_of(BOX)[0]
    axis = best.hand.rotation[:, 1]
    assert abs(axis[1]) > 0.98
    assert best.width == pytest.approx(0.05, abs=0.004)
    assert best.middle[:2] == pytest.approx([BOX.x, BOX.y], abs=0.015)
    assert np.degrees(best.tilt) < 21


@pytest.mark.parametrize("back", [0.0, 0.03, 0.08])
def test_no_grasp_meets_what_is_seen_on_its_way_in(back: float) -> None:
    blocks = (BOX, *NEIGHBOURS)
    frame, _ = view(blocks)
    points = lifted(frame, np.ones(frame.depth.shape, bool))[::5]  # A few millimetres apart.
    near = points[np.linalg.norm(points[:, :2] - [BOX.x, BOX.y], axis=1) < 0.25]
    found = grasps_of(*blocks)
    assert found
    for grasp in found:
        assert inside_hand(grasp, near, back).sum() == 0


def test_every_grasp_fits_the_hand_and_stays_above_the_table() -> None:
    found = grasps_of(BOX, *NEIGHBOURS)
    for grasp in found:
        tip = HAND.pad_reach(grasp.width) + HAND.pad_half[2]
        assert grasp.hand.apply(np.array([[0.0, 0.0, tip]]))[0, 2] > 0.0
        assert grasp.width < grasp.opening <= HAND.max_opening
        assert np.degrees(grasp.tilt) <= 61
    assert [g.merit for g in found] == sorted((g.merit for g in found), reverse=True)


def test_a_flat_thing_is_held_with_the_tips_just_above_the_table() -> None:
    best = grasps_of(Block(0.0, 0.0, (0.12, 0.02, 0.008)))[0]
    tip = HAND.pad_reach(best.width) + HAND.pad_half[2]
    assert 0.001 < best.hand.apply(np.array([[0.0, 0.0, tip]]))[0, 2] < 0.006


def test_what_is_too_wide_or_walled_in_has_no_grasp() -> None:
    assert grasps_of(Block(0.0, 0.0, (0.2, 0.2, 0.05))) == []
    fence = [
        Block(x, y, (0.08, 0.08, 0.15)) for x, y in ((-0.08, 0), (0.08, 0), (0, 0.08), (0, -0.08))
    ]
    assert grasps_of(Block(0.0, 0.0, (0.08, 0.08, 0.05)), *fence) == []


def test_the_same_view_gives_the_same_grasps() -> None:
    assert grasps_of(BOX, *NEIGHBOURS) == grasps_of(BOX, *NEIGHBOURS)


def test_what_is_three_millimetres_narrower_than_the_hand_on_either_side_is_held_across() -> None:
    wide = Block(0.0, 0.0, (0.121, 0.20, 0.08))
    assert max(grasp.width for grasp in grasps_of(wide)) == pytest.approx(0.121, abs=0.003)
    assert grasps_of(Block(0.0, 0.0, (0.127, 0.20, 0.08))) == []
