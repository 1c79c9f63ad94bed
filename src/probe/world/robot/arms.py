"""The arms that a simulated table can have, by name."""

from __future__ import annotations

from probe.scene.setup import ArmName
from probe.world.robot.arm_body import ArmBody
from probe.world.robot.jaco_body import JACO
from probe.world.robot.ur5_body import UR5

ARMS: dict[ArmName, ArmBody] = {"ur5": UR5, "jaco": JACO}
