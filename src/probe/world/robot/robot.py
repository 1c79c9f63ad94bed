"""The whole robot, an arm with its hand, put into a world. Knows no table, camera or task."""

from __future__ import annotations

import mujoco

from probe.scene.setup import ArmMount, ArmName, GripperSize
from probe.world.robot import gripper_model
from probe.world.robot.arm_model import add_arm
from probe.world.robot.arms import ARMS
from probe.world.robot.bodies import add_solids
from probe.world.robot.gripper_model import add_gripper
from probe.world.robot.solids import GREY, SolidBox

PREFIX = "robot/"
"""What every name of the robot's starts with."""

GRIPPER_JOINT = PREFIX + "left_outer_crank"
"""The joint that tells how far the gripper is closed."""

GRIPPER_DRIVE = PREFIX + gripper_model.DRIVE

PADS = tuple(f"{PREFIX}{side}_pad" for side in gripper_model.SIDES)
"""Geoms of the pads."""


def arm_joints(arm: ArmName) -> tuple[str, ...]:
    """Joints and servos of an arm, in order."""
    return tuple(PREFIX + hinge.name for hinge in ARMS[arm].hinges)


def add_robot(spec: mujoco.MjSpec, mount: ArmMount, gripper: GripperSize) -> None:
    """Add the arm, its gripper and, where the base is above the table, a pedestal.

    Args:
        spec: The world to add to.
        mount: Which arm it is, and where it stands.
        gripper: The hand's sizes.
    """
    frame = spec.worldbody.add_frame(pos=mount.base.position, quat=mount.base.wxyz)
    spec.attach(_robot(mount, gripper), prefix=PREFIX, frame=frame)


def _robot(mount: ArmMount, gripper: GripperSize) -> mujoco.MjSpec:
    height, arm = mount.base.position[2], ARMS[mount.arm]
    robot = mujoco.MjSpec()
    robot.compiler.degree = False
    base = robot.worldbody.add_body(name="arm_base")
    if height > 0:
        pedestal = robot.worldbody.add_body(name="pedestal")
        add_solids(pedestal, [SolidBox((0.0, 0.0, -height / 2), (0.075, 0.075, height / 2), GREY)])
    flange = add_arm(robot, base, arm, mount.parked)
    add_gripper(robot, flange, gripper, arm.grip_force)
    return robot
