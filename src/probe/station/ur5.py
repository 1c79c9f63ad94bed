"""The UR5 on its pedestal: kinematics and shape in the world. No motion."""

from __future__ import annotations

import numpy as np

from probe.scene.setup import UR5_TABLE, ArmMount
from probe.station.covering import cover, placed
from probe.types import Array, Pose
from probe.world.robot import ik, ur5
from probe.world.robot.ur5_body import UR5

FOLDED = 2.8
"""Radians of the elbow beyond which the first wrist touches the upper arm, whatever the others."""


class Ur5:
    """The UR5 on its mount as an Arm."""

    endless: tuple[int, ...] = (5,)

    def __init__(self, mount: ArmMount = UR5_TABLE.mount) -> None:
        self.parked = np.array(mount.parked)
        self._world_from_base = mount.base
        self._base_from_world = mount.base.inverse()
        self._link_spheres = [cover(link.solids) for link in UR5.links[:-1]]
        self.at_hand = len(self._link_spheres[-1])

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
            covered.append(placed(spheres, world_from_link))
            world_from_dh = world_from_dh @ ur5.link_transform(index, angle)
        return np.concatenate(covered)


def _turned(angle: float, offset: float) -> Array:
    """A turn about z and a shift along it, shape (4, 4): a link's frame lies on its own joint."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, offset], [0, 0, 0, 1]], dtype=float)
