"""Where the robot's parts are drawn is where the engine has them."""

from __future__ import annotations

import math
from pathlib import Path

import mujoco
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.scene.setup import UR5_TABLE, Setup
from probe.scene.setup_file import read_setup
from probe.types import Array, Pose
from probe.world.robot.frames import arm_frames, finger_frames
from probe.world.robot.gripper import JOINT_LIMIT
from probe.world.robot.robot import PREFIX, arm_joints
from world.robot.rig import world

JACO = read_setup(Path(__file__).parents[3] / "examples" / "setups" / "jaco.json")
MODELS = {setup.name: (setup, world(setup=setup).compile()) for setup in (UR5_TABLE, JACO)}

angles = st.lists(st.floats(-math.pi, math.pi), min_size=6, max_size=6)
fingers = st.floats(0.0, JOINT_LIMIT)


def in_the_engine(setup: Setup, model: mujoco.MjModel, joints: Array, finger: float):
    """world_from_part of every part of the robot."""
    data = mujoco.MjData(model)
    for name, angle in zip(arm_joints(setup.mount.arm), joints, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = angle
    for side in ("left", "right"):
        for part in ("outer_crank", "inner_crank", "finger"):
            data.qpos[model.joint(f"{PREFIX}{side}_{part}").qposadr[0]] = finger
    mujoco.mj_forward(model, data)
    names = [model.body(number).name for number in range(model.nbody)]
    robot = [name.removeprefix(PREFIX) for name in names if name.startswith(PREFIX)]
    return {name: data.body(PREFIX + name) for name in robot if name != "pedestal"}


@pytest.mark.parametrize("name", MODELS)
@given(joints=angles, finger=fingers)
def test_every_part_is_where_the_engine_has_it(
    name: str, joints: list[float], finger: float
) -> None:
    setup, model = MODELS[name]
    expected = in_the_engine(setup, model, np.array(joints), finger)
    found = arm_frames(setup.mount, joints)
    palm = found["palm"]
    found |= {part: palm @ pose for part, pose in finger_frames(finger, setup.gripper).items()}
    expected.pop("flange", None)  # the palm's frame by another name
    assert found.keys() == expected.keys()
    for part, body in expected.items():
        same_place(found[part], body)


def same_place(pose: Pose, body: mujoco.MjData) -> None:
    np.testing.assert_allclose(pose.position, body.xpos, atol=1e-6)
    np.testing.assert_allclose(pose.rotation, body.xmat.reshape(3, 3), atol=1e-6)
