"""The Jaco j2s6s300 on its mount: kinematics and shape in the world. No motion."""

from __future__ import annotations

import numpy as np

from probe.scene.setup import ArmMount
from probe.station.covering import cover, placed
from probe.types import Array, Pose
from probe.world.robot import jaco, jaco_ik
from probe.world.robot.jaco_body import JACO

FOLDED = np.radians(142.0)
"""Bend of joint 5 from straight beyond which the hand's body touches the forearm, radians."""

_FOOT = 0.01


class Jaco:
    """The Jaco as an Arm."""

    endless: tuple[int, ...] = jaco.ENDLESS

    def __init__(self, mount: ArmMount) -> None:
        self.parked = np.array(mount.parked)
        self._world_from_base = mount.base
        self._base_from_world = mount.base.inverse()
        base = cover(JACO.base)
        self._base_spheres = base[base[:, 2] > base[:, 3] + _FOOT]
        self._link_spheres = [cover(link.solids) for link in JACO.links[:-1]]
        self.at_hand = len(self._link_spheres[-1])

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        """Joint angles, each of shape (6,), that reach a tool pose; empty out of reach.

        None of them folds the wrist so far that the hand touches the forearm.
        """
        found = jaco_ik.inverse(self._base_from_world @ world_from_tool)
        return [joints for joints in found if abs(joints[4] - np.pi) < FOLDED]

    def forward(self, joints: Array) -> Pose:
        """world_from_tool of joint angles, shape (6,)."""
        return self._world_from_base @ jaco.forward(joints)

    def spheres(self, joints: Array) -> Array:
        """Spheres that cover the links before the last: x, y, z, radius, shape (k, 4), metres.

        The base is among them, but for its foot, which touches the table.
        """
        world_from_link = self._world_from_base.matrix
        covered = [placed(self._base_spheres, world_from_link)]
        for index, spheres in enumerate(self._link_spheres):
            world_from_link = world_from_link @ jaco.link_transform(index, float(joints[index]))
            covered.append(placed(spheres, world_from_link))
        return np.concatenate(covered)
