from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.dragging import drags
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush
from probe.manipulation.target import target_of
from probe.manipulation.terrain import lifted, survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.types import Array

HAND = Gripper()
BOX = Block(0.02, 0.05, (0.09, 0.05, 0.05))
BEHIND = Block(-0.13, 0.05, (0.2, 0.3, 0.12))
RIGHT = np.array([1.0, 0.0, 0.0])


def first_drags(blocks: Sequence[Block], own: int = 1) -> list[PlannedPush]:
    """Of a thing made of the first few blocks."""
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, np.any(masks[:own], axis=0), terrain)
    return list(islice(drags(target, terrain, HandShape(HAND), RIGHT), 5))


def tips(push: PlannedPush) -> Array:
    half = HAND.pad_half
    low = HAND.pad_reach(0.0) + half[2]
    corners = [[x, y, low] for x in (-half[0], half[0]) for y in (-2 * half[1], 2 * half[1])]
    return push.start.apply(np.array(corners))


def test_the_tips_come_down_on_the_box_where_nothing_else_is_met() -> None:
    blocks = (BOX, BEHIND)
    frame, _ = view(blocks)
    points = lifted(frame, np.ones(frame.depth.shape, bool))
    found = first_drags(blocks)
    assert found and all(push.pressed for push in found)
    for push in found:
        ends = tips(push)
        assert BOX.size[2] < ends[:, 2].min() < BOX.size[2] + 0.005
        low, high = BOX.low[:2] - 0.003, BOX.high[:2] + 0.003
        middle = ends.mean(axis=0)[:2]
        assert (low < middle).all() and (middle < high).all()
        local = push.start.inverse().apply(points)
        for centre, half in HAND.boxes(0.0):
            assert not (np.abs(local - centre) < half).all(axis=1).any()


def test_in_a_tray_the_tips_go_to_its_floor_and_then_to_the_wall_ahead() -> None:
    floor = Block(0.0, 0.0, (0.16, 0.16, 0.01))
    walls = [
        Block(x, y, size)
        for x, y, size in (
            (-0.078, 0.0, (0.005, 0.16, 0.04)),
            (0.078, 0.0, (0.005, 0.16, 0.04)),
            (0.0, -0.078, (0.16, 0.005, 0.04)),
            (0.0, 0.078, (0.16, 0.005, 0.04)),
        )
    ]
    best = first_drags([floor, *walls], own=5)[0]
    ends = tips(best)
    assert 0.01 < ends[:, 2].min() < 0.016
    assert best.gap == pytest.approx(0.0755 - ends[:, 0].max(), abs=0.006)


def test_nothing_is_pressed_through_what_lies_on_it() -> None:
    lid = Block(0.02, 0.05, (0.086, 0.05, 0.02), z=0.05)
    assert first_drags([BOX, lid]) == []
