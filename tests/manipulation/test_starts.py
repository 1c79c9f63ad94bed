from __future__ import annotations

import numpy as np

from manipulation.views import Block, view
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush
from probe.manipulation.starts import close, starts
from probe.manipulation.target import target_of
from probe.manipulation.terrain import survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.types import Pose

BOX = Block(0.02, 0.05, (0.09, 0.05, 0.05))
FENCE = Block(-0.06, 0.05, (0.02, 0.2, 0.02))
RIGHT = np.array([1.0, 0.0, 0.0])
ELSEWHERE = Pose((9.0, 9.0, 9.0), (1.0, 0.0, 0.0, 0.0))


def tried(*unlike: Pose) -> list[PlannedPush]:
    frame, masks = view([BOX, FENCE])
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, masks[0], terrain)
    return starts(target, terrain, HandShape(Gripper()), RIGHT, 0.1, unlike)


def test_it_is_pushed_from_behind_at_first() -> None:
    assert not tried()[0].pressed and not tried()[0].through


def test_after_two_in_vain_it_is_pressed_on_and_then_pushed_with_what_stands_behind() -> None:
    assert tried(ELSEWHERE, ELSEWHERE)[0].pressed
    next_one = tried(ELSEWHERE, ELSEWHERE, ELSEWHERE)[0]
    assert next_one.through and next_one.start.position[0] < FENCE.low[0]


def test_what_was_in_vain_is_not_tried_again() -> None:
    first = tried()[0].start
    assert not any(close(push, first) for push in tried(first))


def test_a_hand_that_may_meet_nothing_else_stays_above_all_others_on_its_way() -> None:
    """What stands aside of the box ahead, where the hand comes by, rules some starts out."""
    beside = Block(0.13, 0.12, (0.04, 0.08, 0.1))
    frame, masks = view([BOX, FENCE, beside])
    terrain = survey(frame, UR5_TABLE)
    target, shape = target_of(frame, masks[0], terrain), HandShape(Gripper())
    every = starts(target, terrain, shape, RIGHT, 0.1, ())
    clear = starts(target, terrain, shape, RIGHT, 0.1, (), clear=True)
    assert clear and any(push.through for push in every)
    for push in clear:
        assert not push.through
        hand = push.start.apply(shape.whole(0.0))
        for gone in np.linspace(0.0, push.gap + 0.1, 8):
            points = hand + gone * RIGHT
            for block in (FENCE, beside):
                assert not ((points > block.low) & (points < block.high)).all(axis=1).any()
