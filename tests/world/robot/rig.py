"""A bare table with the robot on it, and ways to move it; shared by the robot's tests."""

from __future__ import annotations

import math
from dataclasses import dataclass

import mujoco
import numpy as np

from probe.scene.setup import UR5_TABLE, Setup
from probe.types import Array, Pose, quaternion_of
from probe.world.robot import ik
from probe.world.robot.arm_model import servo_command
from probe.world.robot.robot import GRIPPER_DRIVE, GRIPPER_JOINT, add_robot, arm_joints

ARM_JOINTS = arm_joints("ur5")
TOOL_BODY = "robot/wrist_3"
DOWN = np.diag([1.0, -1.0, -1.0])


def world(
    integrator: int = mujoco.mjtIntegrator.mjINT_EULER, setup: Setup = UR5_TABLE
) -> mujoco.MjSpec:
    """The options that the product's world has, a table, and the robot."""
    spec = mujoco.MjSpec()
    spec.option.timestep = 0.003
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10
    spec.option.integrator = integrator
    spec.option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    spec.worldbody.add_geom(name="table", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[2, 2, 0.1])
    add_robot(spec, setup.mount, setup.gripper)
    return spec


@dataclass
class Rig:
    model: mujoco.MjModel
    data: mujoco.MjData

    @staticmethod
    def of(spec: mujoco.MjSpec, joints: Array | None = None) -> Rig:
        model = spec.compile()
        rig = Rig(model, mujoco.MjData(model))
        start = np.array(UR5_TABLE.mount.parked) if joints is None else joints
        rig.data.qpos[rig.arm] = start
        rig.data.ctrl[rig.servos] = start
        mujoco.mj_forward(model, rig.data)
        return rig

    @property
    def arm(self) -> Array:
        return np.array([self.model.joint(name).qposadr[0] for name in ARM_JOINTS])

    @property
    def servos(self) -> Array:
        return np.array([self.model.actuator(name).id for name in ARM_JOINTS])

    @property
    def joints(self) -> Array:
        return self.data.qpos[self.arm].copy()

    @property
    def gripper(self) -> float:
        return float(self.data.joint(GRIPPER_JOINT).qpos[0])

    def tool(self) -> Pose:
        return self.body(TOOL_BODY)

    def body(self, name: str) -> Pose:
        body = self.data.body(name)
        return Pose.of(body.xpos, body.xquat)

    def set_gripper(self, joint: float) -> None:
        """Put all joints of the gripper where a drive at `joint` would have them."""
        for index in range(self.model.njnt):
            name = self.model.joint(index).name
            if name.endswith(("_crank", "_finger")):
                self.data.qpos[self.model.jnt_qposadr[index]] = joint
        self.data.ctrl[self.model.actuator(GRIPPER_DRIVE).id] = joint

    def grip(self, joint: float) -> None:
        self.data.ctrl[self.model.actuator(GRIPPER_DRIVE).id] = joint

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds / self.model.opt.timestep)):
            mujoco.mj_step(self.model, self.data)

    def move(self, goal: Array, speed: float) -> list[tuple[Array, Array]]:
        """Drive to joint angles with minimum jerk; (wanted, actual) of each step."""
        start, dt = self.data.ctrl[self.servos].copy(), self.model.opt.timestep
        trace: list[tuple[Array, Array]] = []
        for step in range(math.ceil(duration(start, goal, speed) / dt) + 1):
            now, velocity = minimum_jerk(start, goal, speed, step * dt)
            self.data.ctrl[self.servos] = servo_command(now, velocity)
            mujoco.mj_step(self.model, self.data)
            trace.append((minimum_jerk(start, goal, speed, (step + 1) * dt)[0], self.joints))
        self.data.ctrl[self.servos] = goal
        return trace


def duration(start: Array, goal: Array, speed: float) -> float:
    """Seconds of a minimum-jerk motion whose fastest joint reaches `speed`."""
    return 1.875 * float(np.abs(goal - start).max()) / speed


def minimum_jerk(start: Array, goal: Array, speed: float, time: float) -> tuple[Array, Array]:
    """Joint angles and velocities at a time (Flash and Hogan, J. Neurosci. 5, 1985)."""
    total = duration(start, goal, speed)
    s = min(time / total, 1.0)
    way = s**3 * (10 - 15 * s + 6 * s**2)
    rate = 30 * s**2 * (1 - s) ** 2 / total
    return start + (goal - start) * way, (goal - start) * rate


def hand_down(point: tuple[float, float, float], reach: float, seed: Array) -> Array:
    """Joint angles that hold the hand straight down with what is `reach` from tool0 at a point."""
    pose = Pose.of(np.asarray(point) + [0.0, 0.0, reach], quaternion_of(DOWN))
    return ik.nearest(ik.inverse(UR5_TABLE.mount.base.inverse() @ pose), seed)
