"""The Jaco in the engine: its frames, its servos, its hand, and what encloses it."""

from __future__ import annotations

import math
from pathlib import Path

import mujoco
import numpy as np
import pytest

from probe.scene.setup_file import read_setup
from probe.station.arms import PEAK_SPEED, arm_of, hand_of
from probe.types import Array, Pose
from probe.world.robot import gripper, jaco
from probe.world.robot.arm_model import servo_command
from probe.world.robot.robot import GRIPPER_DRIVE, GRIPPER_JOINT, PADS, arm_joints
from world.robot.rig import minimum_jerk, world

SETUP = read_setup(Path(__file__).parents[3] / "examples" / "setups" / "jaco.json")
WORKING = np.radians([180.0, 220.0, 250.0, 0.0, 210.0, 20.0])
LOW = np.array([limits[0] if limits else -math.pi for limits in jaco.LIMITS])
HIGH = np.array([limits[1] if limits else math.pi for limits in jaco.LIMITS])


class Bench:
    """The robot alone on a table, with its joints at given angles."""

    def __init__(self, joints: Array) -> None:
        self.model = world(mujoco.mjtIntegrator.mjINT_IMPLICITFAST, SETUP).compile()
        self.data = mujoco.MjData(self.model)
        names = arm_joints("jaco")
        self.arm = [int(self.model.joint(name).qposadr[0]) for name in names]
        self.servos = [int(self.model.actuator(name).id) for name in names]
        self.put(joints)

    def put(self, joints: Array) -> None:
        self.data.qpos[self.arm] = joints
        self.data.ctrl[self.servos] = joints
        mujoco.mj_forward(self.model, self.data)

    def touching(self) -> set[tuple[str, str]]:
        bodies = self.model.geom_bodyid
        return {
            (self.model.body(bodies[hit.geom1]).name, self.model.body(bodies[hit.geom2]).name)
            for hit in self.data.contact
            if hit.dist < 0
        }


def test_model_and_formula_agree() -> None:
    bench, arm = Bench(WORKING), arm_of(SETUP.mount)
    for joints in np.random.default_rng(3).uniform(LOW, HIGH, (50, 6)):
        bench.put(joints)
        tool, expected = bench.data.body("robot/flange"), arm.forward(joints)
        np.testing.assert_allclose(tool.xpos, expected.position, atol=1e-9)
        np.testing.assert_allclose(tool.xmat.reshape(3, 3), expected.rotation, atol=1e-9)


def test_limits_and_mass_are_the_makers() -> None:
    model = Bench(WORKING).model
    for name, limits, torque in zip(
        arm_joints("jaco"), jaco.LIMITS, jaco.TORQUE_LIMIT, strict=True
    ):
        assert bool(model.joint(name).limited[0]) == (limits is not None)
        if limits is not None:
            np.testing.assert_allclose(model.joint(name).range, limits)
        np.testing.assert_allclose(model.actuator(name).forcerange, [-torque, torque])
    # 0.7477 + 0.99 + 0.6763 + 2 x 0.463 + 0.99 kg, and 70 g for six and not three finger links.
    assert model.body("robot/shoulder").subtreemass[0] == pytest.approx(4.33, abs=0.1)


@pytest.mark.parametrize("payload", [0.0, 1.0])
def test_arm_tracks_closely_and_settles(payload: float) -> None:
    bench = Bench(WORKING)
    palm = bench.model.body("robot/palm").id
    bench.data.xfrc_applied[palm, 2] = -9.81 * payload
    goal = WORKING + np.array([0.5, -0.3, 0.3, 0.4, -0.3, 0.5])
    step = bench.model.opt.timestep
    worst = 0.0
    speed = PEAK_SPEED["jaco"]
    for time in np.arange(0.0, 3.0, step):
        now, velocity = minimum_jerk(WORKING, goal, speed, float(time))
        bench.data.ctrl[bench.servos] = servo_command(now, velocity)
        mujoco.mj_step(bench.model, bench.data)
        wanted = minimum_jerk(WORKING, goal, speed, float(time) + step)[0]
        worst = max(worst, float(np.abs(bench.data.qpos[bench.arm] - wanted).max()))
    assert worst < 0.004 + 0.004 * payload
    reached = jaco.forward(bench.data.qpos[bench.arm]).position
    assert math.dist(reached, jaco.forward(goal).position) < 2e-4 + 4e-3 * payload
    assert np.abs(bench.data.qvel).max() < 2e-3


@pytest.mark.parametrize("opening", [0.11, 0.05, 0.0])
def test_pads_are_where_the_hand_says(opening: float) -> None:
    bench, hand = Bench(WORKING), hand_of(SETUP)
    bench.data.ctrl[bench.model.actuator(GRIPPER_DRIVE).id] = gripper.joint_for(
        opening, SETUP.gripper
    )
    for _ in range(400):
        mujoco.mj_step(bench.model, bench.data)
    joint = float(bench.data.joint(GRIPPER_JOINT).qpos[0])
    assert gripper.opening(joint, SETUP.gripper) == pytest.approx(opening, abs=2e-3)
    flange = Pose.of(bench.data.body("robot/flange").xpos, bench.data.body("robot/flange").xquat)
    pads = flange.inverse().apply(np.array([bench.data.geom(name).xpos for name in PADS]))
    assert pads[:, 2] == pytest.approx(hand.pad_reach(opening), abs=2e-3)
    gap = abs(pads[0, 1] - pads[1, 1]) - 2 * hand.pad_half[1]
    assert gap == pytest.approx(opening, abs=2e-3)


def test_the_arms_spheres_cover_its_links() -> None:
    bench, arm = Bench(WORKING), arm_of(SETUP.mount)
    for joints in np.random.default_rng(5).uniform(LOW, HIGH, (5, 6)):
        bench.put(joints)
        spheres = arm.spheres(joints)
        for link in ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2"):
            body = bench.model.body(f"robot/{link}")
            for geom in range(body.geomadr[0], body.geomadr[0] + body.geomnum[0]):
                apart = np.linalg.norm(spheres[:, :3] - bench.data.geom_xpos[geom], axis=1)
                assert (apart < spheres[:, 3]).any()


def test_no_pose_is_reached_with_the_hand_in_the_forearm() -> None:
    bench, arm = Bench(WORKING), arm_of(SETUP.mount)
    beside = {"robot/forearm", "robot/wrist_1", "robot/wrist_2", "robot/hand", "robot/palm"}
    found = 0
    for joints in np.random.default_rng(9).uniform(LOW, HIGH, (60, 6)):
        for solution in arm.inverse(arm.forward(joints)):
            bench.put(solution)
            found += 1
            assert not [pair for pair in bench.touching() if set(pair) <= beside]
    assert found > 100


def test_the_parked_arm_touches_nothing() -> None:
    assert Bench(np.array(SETUP.mount.parked)).touching() == set()
