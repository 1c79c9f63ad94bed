"""Which places the arms get to."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from probe.robot_check.carrying import from_above
from probe.robot_check.reach import out_of_reach
from probe.scene.setup import UR5_TABLE, ArmMount, Setup
from probe.scene.setup_file import read_setup
from probe.station.arms import arm_of, hand_of
from probe.types import Pose
from tabletops import PaintedStation

JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")


class Unmoved(PaintedStation):
    """An arm of a set-up; nobody looks and nothing moves."""

    def __init__(self, setup: Setup) -> None:
        self.arm, self.hand = arm_of(setup.mount), hand_of(setup)


@pytest.mark.parametrize("setup", [UR5_TABLE, JACO], ids=["ur5", "jaco"])
def test_the_arms_get_to_their_work_areas(setup: Setup):
    whole = np.full(6, 4 * np.pi)
    missed, tried = out_of_reach(Unmoved(setup), setup, -whole, whole)
    assert (len(missed), tried) == (0, 50)


def test_a_base_too_far_away_and_joints_that_may_not_turn():
    far = replace(UR5_TABLE, mount=ArmMount(Pose((-1.1, 0.0, 0.2), (0.0, 0.0, 0.0, 1.0))))
    whole = np.full(6, 4 * np.pi)
    missed, tried = out_of_reach(Unmoved(far), far, -whole, whole)
    assert 0 < len(missed) <= tried
    assert missed[:, 0].max() == pytest.approx(0.25)
    near = np.array(UR5_TABLE.mount.parked)
    missed, tried = out_of_reach(Unmoved(UR5_TABLE), UR5_TABLE, near - 0.01, near + 0.01)
    assert len(missed) == tried


def test_a_hand_from_above_points_down_and_turns_with_its_yaw():
    pose = from_above(np.array([0.1, 0.2, 0.3]), np.pi / 2)
    assert pose.rotation[:, 2] == pytest.approx([0, 0, -1])
    assert pose.rotation[:, 0] == pytest.approx([0, 1, 0])
    assert np.linalg.det(pose.rotation) == pytest.approx(1)
