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
