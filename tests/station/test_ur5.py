"""The arm's kinematics in the world, against the engine's own model of it."""

import mujoco
import numpy as np
import pytest

from probe.station.ur5 import Ur5
from probe.types import Pose
from probe.world.model import build_cell

DOWN = (0.0, 1.0, 0.0, 0.0)


@pytest.fixture(scope="module")
def cell():
    model = build_cell([], {})
    return model, mujoco.MjData(model)


def touching(cell, joints) -> set[tuple[str, ...]]:
    """Pairs of the arm's links that overlap, the hand left aside."""
    model, data = cell
    data.qpos[:6] = joints
    mujoco.mj_forward(model, data)
    pairs = [
        sorted(model.body(model.geom_bodyid[geom]).name for geom in (hit.geom1, hit.geom2))
        for hit in data.contact
        if hit.dist < 0
    ]
    links = {"robot/shoulder", "robot/upper_arm", "robot/forearm", "robot/wrist_1"}
    return {tuple(pair) for pair in pairs if set(pair) <= links}


@pytest.mark.parametrize("x", [-0.29, -0.25, -0.2, 0.0, 0.2])
@pytest.mark.parametrize("z", [0.22, 0.3, 0.45])
def test_no_pose_is_reached_by_folding_the_arm_into_itself(cell, x, z):
    arm = Ur5()
    found = [q for y in (-0.15, 0.0, 0.15) for q in arm.inverse(Pose((x, y, z), DOWN))]
    for joints in found:
        assert touching(cell, joints) == set()
    assert found or x < -0.2


def test_the_engine_sees_a_folded_arm_touch_itself(cell):
    folded = np.array([1.57, -1.5, 2.9, 0.0, 1.57, 0.0])
    assert ("robot/upper_arm", "robot/wrist_1") in touching(cell, folded)
