"""Back to the parked place, whatever has happened before. Knows no grasp and no push."""

from __future__ import annotations

import numpy as np

from probe.manipulation.kinematics import line, straight
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.routes import home
from probe.station.station import Station
from probe.types import Array

_RISE = 0.12
"""Straight way up before going home, metres."""

_ATTEMPTS = 6


def park(station: Station, obstacles: Obstacles, points: Array) -> None:
    """Lift straight up as far as it goes, go home and wait until all is still.

    What the arm has just pushed or dropped may stand in a way that was free; then it lifts again
    from where it was stopped, and draws itself in before it turns away.

    Args:
        station: The arm.
        obstacles: What was known before.
        points: On the hand, in its frame, shape (k, 3).
    """
    for attempt in range(_ATTEMPTS):
        _rise(station)
        joints = station.joints()
        drawn_in = np.array([[joints[0], *station.arm.parked[1:]], station.arm.parked])
        way = drawn_in if attempt % 2 else home(station.arm, obstacles, joints, points)
        if station.follow(way):
            break
    station.wait(2.0)


def _rise(station: Station) -> None:
    hand = station.arm.forward(station.joints())
    for height in (_RISE, _RISE / 2):
        up = straight(station.arm, station.joints(), line(hand, (0.0, 0.0, height)))
        if up is not None and station.follow(up):
            return
