"""What the bridge computes of a twin's arm is what the skills compute of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from probe_bridge.config_file import read_config
from probe_bridge.geometry import compose

from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import read_setup
from probe.station.arms import arm_of, hand_of
from probe.twin.config import twin_config

JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")


@pytest.mark.parametrize("setup", [UR5_TABLE, JACO], ids=["ur5", "jaco"])
def test_the_bridges_kinematics_are_the_arms(setup) -> None:
    chain = read_config(twin_config(setup)).chain
    arm, hand = arm_of(setup.mount), hand_of(setup)
    rng = np.random.default_rng(5)
    for _ in range(100):
        joints = rng.uniform([j.lower for j in chain.joints], [j.upper for j in chain.joints])
        tool, pose = compose(chain.links(joints.tolist())[-1], chain.tool), arm.forward(joints)
        assert np.allclose(np.reshape(tool.rotation, (3, 3)), pose.rotation, atol=1e-9)
        assert np.allclose(tool.position, pose.position, atol=1e-9)
        tip = [0.0, 0.0, hand.pad_reach(hand.max_opening) + hand.pad_half[2]]
        assert np.allclose(
            chain.watched(joints.tolist())[-1], pose.apply(np.array([tip])), atol=1e-9
        )


@pytest.mark.parametrize("setup", [UR5_TABLE, JACO], ids=["ur5", "jaco"])
def test_haste_multiplies_speeds_alone(setup) -> None:
    slow, fast = (read_config(twin_config(setup, haste=h)) for h in (1.0, 3.0))
    for one, other in zip(slow.chain.joints, fast.chain.joints, strict=True):
        assert other.speed == pytest.approx(3 * one.speed)
        assert other.acceleration == pytest.approx(9 * one.acceleration)
        assert (other.lower, other.upper) == (one.lower, one.upper)
    assert slow.tool_box == fast.tool_box and slow.home == fast.home
