"""A station whose hand goes a little beside where it is sent: calibration error, as a dial."""

from __future__ import annotations

import numpy as np

from probe.station.station import Arm, Hand, Station
from probe.types import Array, Frame, Pose

_SAME = 1e-3
_ARRIVED = 0.03
_JUMP = 0.5


class OffsetStation:
    """A Station that moves the hand to places shifted by a constant offset, and doesn't know it.

    Only the parked place is as it should be. What the arm reports is where it believes to be, as
    a real arm does whose camera is badly calibrated.

    Args:
        station: The one that acts.
        offset: World, metres, shape (3,).
    """

    def __init__(self, station: Station, offset: Array) -> None:
        self.arm: Arm = station.arm
        self.hand: Hand = station.hand
        self._station = station
        self._offset = np.asarray(offset, float)
        self._believed = self._real = station.joints()

    def observe(self, *, rgb: bool) -> Frame:
        """As Station."""
        return self._station.observe(rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """As Station."""
        return self._station.look_into_basket(rgb=rgb)

    def joints(self) -> Array:
        """Where the arm believes to be; where it was stopped, the angles as measured."""
        measured = self._station.joints()
        arrived = np.abs(measured - self._real).max() < _ARRIVED
        return self._believed if arrived else measured

    def follow(self, path: Array) -> bool:
        """As Station, beside the path."""
        shifted = np.array([self._shifted(joints) for joints in path])
        self._believed, self._real = np.asarray(path[-1]), shifted[-1]
        return self._station.follow(shifted)

    def grip(self, opening: float) -> float:
        """As Station."""
        return self._station.grip(opening)

    def wait(self, seconds: float) -> None:
        """As Station."""
        self._station.wait(seconds)

    def _shifted(self, joints: Array) -> Array:
        """Joint angles that put the hand beside; the same ones where the arm can't get there."""
        if np.abs(joints - self.arm.parked).max() < _SAME:
            return joints
        pose = self.arm.forward(joints)
        beside = Pose.of(np.asarray(pose.position) + self._offset, np.array(pose.wxyz))
        turn = 2 * np.pi
        found = [q + turn * np.round((joints - q) / turn) for q in self.arm.inverse(beside)]
        nearest = min(found, key=lambda q: float(np.abs(q - joints).max()), default=joints)
        return nearest if np.abs(nearest - joints).max() < _JUMP else joints
