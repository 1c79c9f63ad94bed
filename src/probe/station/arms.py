"""A set-up's arm and hand, by the name of the arm."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from probe.scene.setup import ArmMount, ArmName, GripperSize, Setup
from probe.station.gripper import Gripper, JacoHand
from probe.station.jaco import Jaco
from probe.station.station import Arm, Hand
from probe.station.ur5 import Ur5

_ARMS: dict[ArmName, Callable[[ArmMount], Arm]] = {"ur5": Ur5, "jaco": Jaco}
_HANDS: dict[ArmName, Callable[[GripperSize], Hand]] = {"ur5": Gripper, "jaco": JacoHand}

PEAK_SPEED: dict[ArmName, float] = {
    "ur5": float(np.radians(90.0)),
    "jaco": float(np.radians(36.0)),
}
"""Fastest turn of any joint, radians a second: half of what the UR5 can do, and all that the
Jaco's slowest joints can."""


def arm_of(mount: ArmMount) -> Arm:
    """The kinematics of the arm on a mount."""
    return _ARMS[mount.arm](mount)


def hand_of(setup: Setup) -> Hand:
    """The shape of a set-up's hand."""
    return _HANDS[setup.mount.arm](setup.gripper)
