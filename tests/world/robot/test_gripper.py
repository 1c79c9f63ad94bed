from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.world.robot import gripper
from world.robot.urdf import Urdf

VENDOR_PAD_THICKNESS = 0.0075


@given(joint=st.floats(0.0, 0.699))
def test_opening_and_joint_are_inverse(joint: float) -> None:
    assert gripper.joint_for(gripper.opening(joint)) == pytest.approx(joint, abs=1e-9)


def test_stated_range() -> None:
    assert pytest.approx(0.1285, abs=2e-4) == gripper.opening(0.0)
    assert gripper.opening(gripper.JOINT_LIMIT) == 0.0
    openings = [gripper.opening(joint) for joint in np.linspace(0, 0.69, 50)]
    assert openings == sorted(openings, reverse=True)


def test_beyond_the_range_is_refused() -> None:
    with pytest.raises(ValueError, match="opens from 0"):
        gripper.joint_for(0.14)


def test_pads_lie_where_the_vendors_description_puts_them(assets: Path) -> None:
    urdf = Urdf.read(assets / "robots" / "robotiq_2f_140" / "robotiq_2f_140.urdf")
    for joint in np.linspace(0, gripper.JOINT_LIMIT, 15):
        turned = {
            "finger_joint": joint,
            "left_inner_finger_joint": joint,  # mimic, multiplier 1
        }
        pad = urdf.forward("robotiq_arg2f_base_link", "left_inner_finger_pad", turned)
        gap = 2 * -pad[1, 3] - VENDOR_PAD_THICKNESS
        assert gripper.opening(joint) == pytest.approx(max(gap, 0.0), abs=1e-4)
        assert gripper.pad_reach(joint) == pytest.approx(pad[2, 3], abs=1e-4)
        assert math.degrees(math.acos(min(1.0, abs(pad[1, 2])))) < 0.1  # the face looks along y


def test_drive_of_the_stated_forces() -> None:
    weak, strong = (gripper.tendon_force(force) for force in gripper.FORCE_RANGE)
    assert strong / weak == pytest.approx(12.5)
