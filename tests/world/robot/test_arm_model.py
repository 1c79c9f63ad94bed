from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest

from probe.scene.setup import UR5_TABLE
from probe.types import Pose
from probe.world.robot import ur5
from world.robot.rig import ARM_JOINTS, Rig, world

INTEGRATORS = [mujoco.mjtIntegrator.mjINT_EULER, mujoco.mjtIntegrator.mjINT_IMPLICITFAST]
WORKING = np.array([0.0, -1.6, 1.9, -1.9, -1.57, 0.0])
PADS_AT = Pose((0.0, 0.0, 0.2))  # from tool0


def test_model_and_formula_agree_even_on_fresh_data_with_sleeping_enabled() -> None:
    model = world().compile()
    arm = [model.joint(name).qposadr[0] for name in ARM_JOINTS]
    rng = np.random.default_rng(3)
    for joints in rng.uniform(-math.pi, math.pi, (100, 6)):
        data = mujoco.MjData(model)
        data.qpos[arm] = joints
        mujoco.mj_forward(model, data)
        tool = data.body("robot/wrist_3")
        expected = UR5_TABLE.mount.base @ ur5.forward(joints)
        np.testing.assert_allclose(tool.xpos, expected.position, atol=1e-6)
        np.testing.assert_allclose(tool.xmat.reshape(3, 3), expected.rotation, atol=1e-6)


def test_limits_and_masses_are_the_makers() -> None:
    model = world().compile()
    for index, name in enumerate(ARM_JOINTS):
        limit = ur5.JOINT_LIMIT[index]
        np.testing.assert_allclose(model.joint(name).range, [-limit, limit])
        torque = ur5.TORQUE_LIMIT[index]
        np.testing.assert_allclose(model.actuator(name).forcerange, [-torque, torque])
    assert model.body("robot/shoulder").subtreemass[0] == pytest.approx(18.05, abs=0.02)


def loaded(integrator: int, payload: float) -> Rig:
    spec = world(integrator)
    if payload:
        load = spec.body("robot/palm").add_body(name="load", pos=PADS_AT.position)
        load.add_geom(size=[0.03, 0, 0], mass=payload, contype=0, conaffinity=0)
    rig = Rig.of(spec, WORKING)
    rig.model.geom_contype[:] = 0  # the paths are random: only tracking is looked at
    return rig


def pad_error(wanted: np.ndarray, actual: np.ndarray) -> float:
    there, here = (ur5.forward(joints) @ PADS_AT for joints in (wanted, actual))
    return float(np.linalg.norm(np.subtract(there.position, here.position)))


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize(("speed_deg", "payload"), [(60, 0.0), (90, 0.0), (90, 1.0)])
def test_arm_tracks_closely_and_settles_without_overshoot(
    integrator: int, speed_deg: float, payload: float
) -> None:
    rig, rng = loaded(integrator, payload), np.random.default_rng(5)
    goals = WORKING + rng.uniform(-0.9, 0.9, (4, 6))
    for goal in goals:
        start = rig.joints
        for wanted, actual in rig.move(goal, math.radians(speed_deg)):
            assert pad_error(wanted, actual) < 2.5e-3
        beyond = 0.0
        for _ in range(250):
            rig.wait(0.003)
            beyond = max(beyond, float(((rig.joints - goal) * np.sign(goal - start)).max()))
        sag = 2e-3 * payload
        assert beyond < 5e-4 + sag
        assert pad_error(goal, rig.joints) < 1e-4 + sag
        assert np.abs(rig.data.qvel).max() < 1e-3


def test_arm_stands_still_against_gravity() -> None:
    rig = Rig.of(world(), WORKING)
    rig.wait(3.0)
    assert pad_error(WORKING, rig.joints) < 1e-4
