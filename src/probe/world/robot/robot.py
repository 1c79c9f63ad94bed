"""The whole robot, a UR5 with a 2F-140, put into a world. Knows no table, camera or task."""

from __future__ import annotations

import math

import mujoco

from probe.types import Pose
from probe.world.robot import gripper_model, ur5
from probe.world.robot.arm_model import add_arm
from probe.world.robot.bodies import add_solids
from probe.world.robot.gripper_model import add_gripper
from probe.world.robot.solids import GREY, SolidBox

PREFIX = "robot/"
"""What every name of the robot's starts with."""

ARM_JOINTS = tuple(PREFIX + name for name in ur5.JOINTS)
"""Joints and servos of the arm, in order."""

GRIPPER_JOINT = PREFIX + "left_outer_crank"
"""The joint that tells how far the gripper is closed."""

GRIPPER_DRIVE = PREFIX + gripper_model.DRIVE

TOOL_BODY = PREFIX + "wrist_3"
"""The body whose frame is tool0."""

PADS = tuple(f"{PREFIX}{side}_pad" for side in gripper_model.SIDES)
"""Geoms of the pads."""

BASE_POSE = Pose((-0.5, 0.0, 0.2), (0.0, 0.0, 0.0, 1.0))
"""world_from_base for a work area of +-0.3 m around the origin: at shoulder pan 0 the arm points
along +x over it. On its pedestal the arm grasps every point up to 0.3 m high from above; standing
on the table it would miss an eighth of them."""

PARKED = (math.pi / 2, -1.9, 2.2, -0.3 - math.pi / 2, -math.pi / 2, 0.0)
"""Arm joints, radians, that keep the robot behind x = -0.42 m for `BASE_POSE`, hand down."""


def add_robot(spec: mujoco.MjSpec, base_pose: Pose) -> None:
    """Add the arm, its gripper and, where the base is above the table, a pedestal.

    Args:
        spec: The world to add to.
        base_pose: world_from_base, metres.
    """
    frame = spec.worldbody.add_frame(pos=base_pose.position, quat=base_pose.wxyz)
    spec.attach(_robot(base_pose.position[2]), prefix=PREFIX, frame=frame)


def _robot(height: float) -> mujoco.MjSpec:
    robot = mujoco.MjSpec()
    robot.compiler.degree = False
    base = robot.worldbody.add_body(name="arm_base")
    if height > 0:
        pedestal = robot.worldbody.add_body(name="pedestal")
        add_solids(pedestal, [SolidBox((0.0, 0.0, -height / 2), (0.075, 0.075, height / 2), GREY)])
    add_gripper(robot, add_arm(robot, base, PARKED))
    return robot
