"""A set-up's arm as the bridge describes arms: joints with origins, as in a URDF."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from probe.scene.setup import ArmName, Setup
from probe.station.arms import hand_of
from probe.types import Array
from probe.world.robot import jaco, ur5

_ACCELERATION: dict[ArmName, float] = {"ur5": 4.0, "jaco": 2.0}
"""Of every joint, radians a second squared: what both arms do without effort."""

_ENDLESS = 4 * np.pi


def joints_of(arm: ArmName, speed: float) -> tuple[list[dict[str, Any]], Array]:
    """The joints for a bridge's file, from the base outwards, and last_link_from_tool0, (4, 4).

    Args:
        arm: Which.
        speed: Limit of each joint, radians a second.
    """
    names, origins, tool = _hinges(arm)
    limits = _limits(arm)
    joints = [
        {
            "name": name,
            **origin_of(origin),
            "axis": [0, 0, 1],
            "lower": low,
            "upper": high,
            "speed": speed,
            "acceleration": _ACCELERATION[arm] * (speed / _usual_speed(arm)) ** 2,
        }
        for name, origin, (low, high) in zip(names, origins, limits, strict=True)
    ]
    return joints, tool


def points_of(setup: Setup, tool: Array) -> list[dict[str, Any]]:
    """Points along the arm that must stay in its box: where its joints are, and the finger tips.

    The tips as they are while the hand is open: they reach further down as it closes, which
    skills allow for.
    """
    hand = hand_of(setup)
    reach = hand.pad_reach(hand.max_opening) + hand.pad_half[2]
    tip = tool @ np.array([0.0, 0.0, reach, 1.0])
    elbows = [{"after": after, "xyz": [0, 0, 0]} for after in range(2, 6)]
    return [*elbows, {"after": 6, "xyz": tip[:3].tolist()}]


def origin_of(matrix: Array) -> dict[str, list[float]]:
    """A transform, shape (4, 4), as a URDF writes it: metres and fixed-axis angles."""
    turned = Rotation.from_matrix(matrix[:3, :3])
    # Where yaw and roll turn about the same axis, any split of the two will do.
    yaw, pitch, roll = turned.as_euler("ZYX", suppress_warnings=True)
    return {"xyz": matrix[:3, 3].tolist(), "rpy": [float(roll), float(pitch), float(yaw)]}


def _hinges(arm: ArmName) -> tuple[tuple[str, ...], list[Array], Array]:
    """Names, parent_from_joint of each joint at angle zero, and what follows the last one."""
    if arm == "jaco":
        origins = [jaco.link_transform(index, 0.0) for index in range(6)]
        return jaco.JOINTS, origins, np.diag([1.0, -1.0, -1.0, 1.0])
    # Denavit's frames lie behind their joints: each joint turns the frame before it.
    behind = [ur5.link_transform(index, 0.0) for index in range(6)]
    return ur5.JOINTS, [np.eye(4), *behind[:-1]], behind[-1]


def _limits(arm: ArmName) -> list[tuple[float, float]]:
    if arm == "jaco":
        return [limit or (-_ENDLESS, _ENDLESS) for limit in jaco.LIMITS]
    return [(-float(limit), float(limit)) for limit in ur5.JOINT_LIMIT]


def _usual_speed(arm: ArmName) -> float:
    return jaco.JOINT_SPEED if arm == "jaco" else ur5.JOINT_SPEED / 2
