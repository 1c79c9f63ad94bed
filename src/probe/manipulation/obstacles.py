"""Whether the arm, its hand and what it carries keep clear of the terrain. Plans nothing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.manipulation.kinematics import between
from probe.manipulation.terrain import Terrain
from probe.station.station import Arm
from probe.types import Array

_ARM_WIDTH = 0.05
_SPARE = 0.005
_APART = 0.01
"""Metres between hand and arm on the way, which is checked in steps."""


@dataclass(frozen=True, eq=False)
class Obstacles:
    """What the arm must not touch.

    Attributes:
        arm: Its kinematics.
        terrain: Heights for the hand and what it carries.
        wide: The same grown by half an arm's width, for the arm.
    """

    arm: Arm
    terrain: Terrain
    wide: Terrain

    @staticmethod
    def of(arm: Arm, terrain: Terrain) -> Obstacles:
        """Obstacles that a terrain shows."""
        return Obstacles(arm, terrain, terrain.widened(_ARM_WIDTH))

    def free(self, path: Array, points: Array) -> bool:
        """Whether a joint path, shape (m, n) with m > 1, is free for arm and hand.

        Args:
            path: Waypoints; checked in between as well.
            points: On the hand and what it carries, in the hand's frame, shape (k, 3).
        """
        return all(self.free_at(joints, points) for joints in between(path))

    def arm_free(self, joints: Array) -> bool:
        """Whether the arm without its hand is free."""
        return self._is_above(self.arm.spheres(joints))

    def free_at(self, joints: Array, points: Array) -> bool:
        """Whether arm and hand are free of the terrain and of each other."""
        spheres = self.arm.spheres(joints)
        if not self._is_above(spheres):
            return False
        world = self.arm.forward(joints).apply(points)
        if (world[:, 2] < self.terrain.below(world) + _SPARE).any():
            return False
        return self._is_apart(world, spheres, _APART)

    def unfolded(self, joints: Array, points: Array, spare: float = 0.0) -> bool:
        """Whether the hand and what it carries are free of the arm, by some metres.

        The link beside the hand is left out: the two touch nowhere, however they turn.
        """
        world = self.arm.forward(joints).apply(points)
        return self._is_apart(world, self.arm.spheres(joints), spare)

    def _is_above(self, spheres: Array) -> bool:
        """Whether the arm's spheres, shape (k, 4), are free of the terrain."""
        lowest = spheres[:, 2] - spheres[:, 3]
        return bool((lowest > self.wide.below(spheres[:, :3]) + _SPARE).all())

    def _is_apart(self, world: Array, spheres: Array, spare: float) -> bool:
        """Whether points in the world, shape (m, 3), are free of the arm's spheres; see above."""
        spheres = spheres[: -self.arm.at_hand]
        apart = np.linalg.norm(world[:, None] - spheres[None, :, :3], axis=2)
        return bool((apart > spheres[:, 3] + spare).all())
