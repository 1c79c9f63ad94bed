"""Where each part of a robot is at given joint angles. Knows no engine and no shapes."""

from __future__ import annotations

import math
from collections.abc import Sequence

from probe.scene.setup import ArmMount, GripperSize
from probe.types import Array, Pose, Quaternion
from probe.world.robot.arms import ARMS
from probe.world.robot.gripper import INNER_PIVOT, PIVOT, TILT, crank

_HALF_TURN_X = Pose((0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0))
_HALF_TURN_Z = Pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def arm_frames(mount: ArmMount, joints: Sequence[float] | Array) -> dict[str, Pose]:
    """world_from_part of an arm's base, of its links by name, and of the hand ("palm").

    Args:
        mount: Which arm it is, and where it stands.
        joints: Angles in radians, one a hinge.
    """
    arm = ARMS[mount.arm]
    pose = mount.base
    frames = {"arm_base": pose}
    for hinge, link, angle in zip(arm.hinges, arm.links, joints, strict=True):
        turned = Pose((hinge.shift, 0.0, 0.0), _about(0, hinge.twist))
        pose = pose @ turned @ Pose((0.0, 0.0, hinge.along), _about(2, angle + hinge.offset))
        frames[link.name] = pose
    frames["palm"] = pose @ _HALF_TURN_X if arm.flipped else pose
    return frames


def finger_frames(joint: float, size: GripperSize) -> dict[str, Pose]:
    """tool0_from_part of the parts of both fingers, by name, at a joint angle of the gripper."""
    turned = _about(0, TILT - joint)
    length, tilt = crank(size), TILT - joint
    out, up = PIVOT[0] + length * math.sin(tilt), PIVOT[1] + length * math.cos(tilt)
    left = {
        "outer_crank": Pose((0.0, -PIVOT[0], PIVOT[1]), turned),
        "inner_crank": Pose((0.0, -INNER_PIVOT[0], INNER_PIVOT[1]), turned),
        "finger": Pose((0.0, -out, up)),
    }
    return {f"left_{name}": pose for name, pose in left.items()} | {
        f"right_{name}": _HALF_TURN_Z @ pose for name, pose in left.items()
    }


def _about(axis: int, angle: float) -> Quaternion:
    """A turn about x (0) or z (2) as a quaternion."""
    c, s = math.cos(angle / 2), math.sin(angle / 2)
    return (c, s, 0.0, 0.0) if axis == 0 else (c, 0.0, 0.0, s)
