"""The closed hand along a straight line at the table, by touch. Plans nothing ahead."""

from __future__ import annotations

import numpy as np

from probe.manipulation.kinematics import between, line, moved, straight
from probe.station.station import Station
from probe.types import Array, Pose

_CREEP = 0.004
_DOWN, _DEEPEST = 0.002, 0.014
_FELT = 0.0015
_BACK, _OVER, _LIFTS = 0.015, 0.015, 2


def swept(station: Station, path: Array, way: Array) -> float:
    """Follow a path along a way, shape (3,); stopped, the hand draws back and goes on higher.

    Returns:
        Metres that it came along the way.
    """
    along = way / np.linalg.norm(way)
    begin = _hand(station)
    for lift in range(_LIFTS + 1):
        if _followed(station, path) or lift == _LIFTS:
            break
        for shift in (-_BACK * along, np.array([0.0, 0.0, _OVER])):
            aside = _path(station, shift)
            if aside is None or not station.follow(aside):
                break
        rest = way - along * (_gone(station, begin) @ along)
        onward = _path(station, rest)
        if onward is None:
            break
        path = np.vstack([station.joints(), onward])
    return float(_gone(station, begin) @ along)


def pressed(station: Station, joints: Array) -> Array:
    """Let the hand down from joint angles until it feels what it stands on, or is too deep.

    Returns:
        The joint angles commanded last: a little below where the hand is, so that it presses.
    """
    start, free = station.arm.forward(joints), _hand(station).position[2]
    for depth in np.arange(_DOWN, _DEEPEST, _DOWN):
        down = straight(station.arm, joints, [moved(start, (0.0, 0.0, -depth))])
        if down is None or not station.follow(down):
            break
        joints = down[-1]
        if _hand(station).position[2] - (free - depth) > _FELT:
            break
    return joints


def _followed(station: Station, path: Array) -> bool:
    """In small steps, so that it stops near what it meets."""
    return all(station.follow(joints[None]) for joints in between(path, _CREEP)[1:])


def _path(station: Station, shift: Array) -> Array | None:
    return straight(station.arm, station.joints(), line(_hand(station), shift))


def _hand(station: Station) -> Pose:
    return station.arm.forward(station.joints())


def _gone(station: Station, begin: Pose) -> Array:
    return np.subtract(_hand(station).position, begin.position)
