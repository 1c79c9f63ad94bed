"""Back to the parked place, whatever has happened before. Knows no grasp and no push."""

from __future__ import annotations

import numpy as np

from probe.errors import ProbeError
from probe.manipulation.kinematics import line, straight
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.routes import home
from probe.station.station import Station
from probe.types import Array

_RISE = 0.12
"""Straight way up before going home, metres."""

_ROUNDS = 3
_RETREATS = 2
_REST = 2.0
_STEPS = np.linspace(-0.12, 0.12, 7)
_NEIGHBOURHOOD = np.array([(x, y, 0.0) for x in _STEPS for y in _STEPS])
"""Places around the hand, metres, at which what stood there is told of an arm that is stuck."""

_SHOULDER, _WRIST = slice(1, None), slice(3, None)
"""Joints that go home first: all but the one that turns the whole arm; those of the wrist."""


class ArmStuck(ProbeError):
    """An arm that got home on none of the ways that there are."""

    def __init__(self, station: Station, obstacles: Obstacles) -> None:
        joints = station.joints()
        hand = np.array(station.arm.forward(joints).position)
        around = hand + _NEIGHBOURHOOD
        height = float(obstacles.terrain.below(around).max())
        joint = int(np.abs(joints - station.arm.parked).argmax())
        x, y, z = hand
        short = abs(float(joints[joint] - station.arm.parked[joint]))
        super().__init__(
            f"The arm can't be brought home: every way there is blocked, and joint {joint + 1} is "
            f"{short:.2f} rad short of it. The hand is at x {x:.2f}, y {y:.2f}, z {z:.2f} m; what "
            f"was known to stand around it is up to {height:.2f} m high. Look what holds it, and "
            "bring it home by hand."
        )


def park(station: Station, obstacles: Obstacles, points: Array, came: Array) -> None:
    """Lift straight up as far as it goes, go home and wait until all is still.

    What the arm has just pushed or dropped may stand in a way that was free; then it lifts again
    from where it was stopped, and draws itself in before it turns away. A hand that has met the
    forearm comes free when it closes and the wrist turns back first. If all of that is in vain, it
    draws back along the way that it came, which was free a moment ago, with closed fingers and
    with open ones.

    Args:
        station: The arm.
        obstacles: What was known before.
        points: On the hand, in its frame, shape (k, 3).
        came: Joint angles by which it came here from home, shape (m, n); it may have been stopped
            before the end.

    Raises:
        ArmStuck: Nothing of that brought it home.
    """
    ways = (_straight_home, _drawn_in, _unbent) * _ROUNDS
    if not any(way(station, obstacles, points) for way in ways):
        openings = (0.0, station.hand.max_opening) * _RETREATS
        if not any(_retreated(station, obstacles, points, came, opening) for opening in openings):
            raise ArmStuck(station, obstacles)
    station.wait(_REST)


def _retreated(
    station: Station, obstacles: Obstacles, points: Array, came: Array, opening: float
) -> bool:
    """Back along the way that it came, or as far as that goes and home from there.

    Whatever has just been in the way is given time to come to rest.
    """
    station.wait(_REST)
    station.grip(opening)
    nearest = int(np.abs(came - station.joints()).max(axis=1).argmin())
    back = np.vstack([came[nearest::-1], station.arm.parked])
    return station.follow(back) or _straight_home(station, obstacles, points)


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
