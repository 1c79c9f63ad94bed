"""Two parallel pads on cranks as a Hand."""

from __future__ import annotations

import numpy as np

from probe.scene.setup import GripperSize
from probe.types import Array
from probe.world.robot import gripper, gripper_shape
from probe.world.robot.jaco_body import HAND_BODY


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


class JacoHand(Gripper):
    """Two fingers where the Jaco's hand has three, on the hand's own body."""

    def boxes(self, opening: float) -> list[tuple[Array, Array]]:
        """Centres and half sizes, shape (3,), of boxes that enclose the hand, tool frame."""
        radius, length = HAND_BODY
        body = np.array([0.0, 0.0, length / 2]), np.array([radius, radius, length / 2])
        return [body, *super().boxes(opening)]
