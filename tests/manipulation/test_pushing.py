from __future__ import annotations

from itertools import islice

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush, pushes
from probe.manipulation.target import target_of
from probe.manipulation.terrain import lifted, survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.types import Array

HAND = Gripper()
BOX = Block(0.02, 0.05, (0.09, 0.05, 0.05))
CLUTTER = (Block(-0.09, 0.05, (0.03, 0.05, 0.04)), Block(0.02, 0.13, (0.09, 0.03, 0.08)))
ALONG = [np.array(v, float) for v in ([1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0])]


def first_pushes(along: Array, *blocks: Block) -> list[PlannedPush]:
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, masks[0], terrain)
    return list(islice(pushes(target, terrain, HandShape(HAND), along, 0.1), 5))


def tips(push: PlannedPush) -> Array:
    half = HAND.pad_half
    low = HAND.pad_reach(0.0) + half[2]
    corners = [[x, y, low] for x in (-half[0], half[0]) for y in (-2 * half[1], 2 * half[1])]
    return push.start.apply(np.array(corners))


@pytest.mark.parametrize("along", ALONG)
def test_a_push_starts_behind_a_free_box_low_and_close(along: Array) -> None:
    best = first_pushes(along, BOX)[0]
    rear = (np.array([BOX.x, BOX.y, 0.0]) @ along) - abs(np.array([0.045, 0.025, 0.0]) @ along)
    front = float((tips(best) @ along).max())
    assert rear - front == pytest.approx(best.gap, abs=0.005)
    assert best.gap < 0.02
    assert 0.0 < tips(best)[:, 2].min() < 0.016
    aside = np.cross([0, 0, 1], along)
    assert float(tips(best).mean(axis=0) @ aside) == pytest.approx(
        float(np.array([BOX.x, BOX.y, 0]) @ aside), abs=0.01
    )


@pytest.mark.parametrize("along", ALONG)
def test_the_hand_starts_free_of_all_that_is_seen(along: Array) -> None:
    blocks = (BOX, *CLUTTER)
    frame, _ = view(blocks)
    points = lifted(frame, np.ones(frame.depth.shape, bool))
    for push in first_pushes(along, *blocks):
        local = push.start.inverse().apply(points)
        for centre, half in HAND.boxes(0.0):
            assert not (np.abs(local - centre) < half).all(axis=1).any()


def test_there_is_no_push_without_room_behind() -> None:
    wall = Block(-0.195, 0.05, (0.34, 0.4, 0.15))
    assert first_pushes(ALONG[0], BOX, wall) == []
