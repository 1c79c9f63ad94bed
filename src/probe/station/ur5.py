"""The UR5 with its 2F-140 on its pedestal: kinematics and shape in the world. No motion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.scene.setup import UR5_TABLE, ArmMount, GripperSize
from probe.types import Array, Pose
from probe.world.robot import gripper, gripper_shape, ik, ur5
from probe.world.robot.arm_model import LINKS
from probe.world.robot.solids import Cylinder

_SPACING = 0.05

FOLDED = 2.8
"""Radians of the elbow beyond which the first wrist touches the upper arm, whatever the others."""


class Gripper:
    """The 2F-140 as a Hand, or one of other sizes."""

    def __init__(self, size: GripperSize = gripper.ROBOTIQ_2F140) -> None:
        self.max_opening = size.max_opening
        self.pad_half = gripper.pad_half(size)
        self._size = size

    def pad_reach(self, opening: float) -> float:
        """Distance along z from the tool frame to the middle of the pads, metres."""
        return gripper.pad_reach(gripper.joint_for(opening, self._size), self._size)

    def boxes(self, opening: float) -> list[tuple[Array, Array]]:
        """Centres and half sizes, shape (3,), of boxes that enclose the hand, tool frame."""
        return gripper_shape.boxes(opening, self._size)


class Ur5:
    """The UR5 on its mount as an Arm."""

    def __init__(self, mount: ArmMount = UR5_TABLE.mount) -> None:
        self.parked = np.array(mount.parked)
        self._world_from_base = mount.base
        self._base_from_world = mount.base.inverse()
        self._link_spheres = [_cover(link.solids) for link in LINKS[:-1]]

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        """Joint angles, each of shape (6,), that reach a tool pose; empty out of reach.

        None of them folds the arm so far that it touches itself.
        """
        found = ik.inverse(self._base_from_world @ world_from_tool)
        return [joints for joints in found if abs(joints[2]) < FOLDED]

    def forward(self, joints: Array) -> Pose:
        """world_from_tool of joint angles, shape (6,)."""
        return self._world_from_base @ ur5.forward(joints)

    def spheres(self, joints: Array) -> Array:
        """Spheres that cover the links before the last: x, y, z, radius, shape (k, 4), metres."""
        world_from_dh = self._world_from_base.matrix
        covered: list[Array] = []
        for index, spheres in enumerate(self._link_spheres):
            angle = float(joints[index])
            world_from_link = world_from_dh @ _turned(angle, ur5.D[index])
            centres = spheres[:, :3] @ world_from_link[:3, :3].T + world_from_link[:3, 3]
            covered.append(np.column_stack([centres, spheres[:, 3]]))
            world_from_dh = world_from_dh @ ur5.link_transform(index, angle)
        return np.concatenate(covered)


def _turned(angle: float, offset: float) -> Array:
    """A turn about z and a shift along it, shape (4, 4): a link's frame lies on its own joint."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, offset], [0, 0, 0, 1]], dtype=float)


def _cover(solids: Sequence[Cylinder]) -> Array:
    """Spheres along the axes of cylinders: x, y, z, radius, shape (k, 4), in their link's frame."""
    rows: list[Array] = []
    for solid in solids:
        start, end = np.array(solid.start), np.array(solid.end)
        count = max(2, int(np.ceil(np.linalg.norm(end - start) / _SPACING)) + 1)
        centres = np.linspace(start, end, count)
        rows.append(np.column_stack([centres, np.full(count, solid.radius)]))
    return np.concatenate(rows)
