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

_ROUNDS = 3
_SHOULDER, _WRIST = slice(1, None), slice(3, None)
"""Joints that go home first: all but the one that turns the whole arm; those of the wrist."""


def park(station: Station, obstacles: Obstacles, points: Array) -> None:
    """Lift straight up as far as it goes, go home and wait until all is still.

    What the arm has just pushed or dropped may stand in a way that was free; then it lifts again
    from where it was stopped, and draws itself in before it turns away. A hand that has met the
    forearm comes free when it closes and the wrist turns back first.

    Args:
        station: The arm.
        obstacles: What was known before.
        points: On the hand, in its frame, shape (k, 3).
    """
    ways = (_straight_home, _drawn_in, _unbent) * _ROUNDS
    any(way(station, obstacles, points) for way in ways)
    station.wait(2.0)


def _straight_home(station: Station, obstacles: Obstacles, points: Array) -> bool:
    _rise(station)
    return station.follow(home(station.arm, obstacles, station.joints(), points))


def _drawn_in(station: Station, obstacles: Obstacles, points: Array) -> bool:
    _rise(station)
    return station.follow(_turning(station, _SHOULDER))


def _unbent(station: Station, obstacles: Obstacles, points: Array) -> bool:
    station.grip(0.0)
    return station.follow(_turning(station, _WRIST))


def _turning(station: Station, first: slice) -> Array:
    """Home by way of where some joints are as when parked and the others as they are."""
    between = station.joints()
    between[first] = station.arm.parked[first]
    return np.array([between, station.arm.parked])


def _rise(station: Station) -> None:
    hand = station.arm.forward(station.joints())
    for height in (_RISE, _RISE / 2):
        up = straight(station.arm, station.joints(), line(hand, (0.0, 0.0, height)))
        if up is not None and station.follow(up):
            return
