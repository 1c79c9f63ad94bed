"""Whether pictures are fresh and whole, and whether what they are said to be can be right."""

from __future__ import annotations

import time
from array import array
from typing import List, NamedTuple, Optional, Sequence

from probe_bridge.checks.clock import ClockWatch
from probe_bridge.checks.messages import share
from probe_bridge.checks.optics import wrong_optics
from probe_bridge.checks.outcome import Measure, Outcome, failed, passed
from probe_bridge.client import RobotClient
from probe_bridge.description import Picture

_COUNT = 8
STALE = 0.25
"""Seconds by which a picture may be older than the call that asked for it, as in RobotStation."""

_OFTEN = 3
"""So many old pictures make a fault: a clock that jumps makes one of them seem old."""

_EVERY = 7
"""Of so many pixels, one is looked at."""

_NEAR, _FAR = 0.15, 6.0
"""Metres within which what a table's camera sees on average must lie."""

_HOLES = 0.4
_SLOW = 2.5
"""Most holes; and how much longer than usual a picture takes if others were lost before it."""


class Taken(NamedTuple):
    """A picture, what the robot's clock was when it was asked for, and how long it took."""

    picture: Picture
    asked: float
    seconds: float


def check_frames(client: RobotClient, clock: ClockWatch, camera: str) -> Outcome:
    """Look through a camera several times.

    Args:
        client: Connected.
        clock: Asked before each picture.
        camera: Its name.
    """
    name = f"frames of {camera}"
    wrong = wrong_optics(name, client.description.cameras[camera])
    if wrong:
        return wrong
    taken = [_taken(client, clock, camera) for _ in range(_COUNT)]
    depths = [_depths(each.picture) for each in taken]
    measures = _measures(taken, depths)
    return _wrong_times(name, taken, measures) or _wrong_depths(name, taken, depths, measures)


def _taken(client: RobotClient, clock: ClockWatch, camera: str) -> Taken:
    asked, before = clock.look(client), time.monotonic()
    picture = client.observe(camera, rgb=True)
    return Taken(picture, asked, time.monotonic() - before)


def _depths(picture: Picture) -> Sequence[int]:
    """Some of the depths, in steps; zeros are holes."""
    values = array("H")
    values.frombytes(picture.depth)  # little-endian, as every computer is that runs this
    return values[::_EVERY]


def _measures(taken: Sequence[Taken], depths: Sequence[Sequence[int]]) -> List[Measure]:
    times = [each.seconds for each in taken]
    usual = share(times, 0.5)
    ages = [each.asked - each.picture.stamp for each in taken]
    holes = sum(row.count(0) for row in depths) / sum(map(len, depths))
    return [
        Measure("a picture takes", 1000 * usual, "ms"),
        Measure("oldest", max(0.0, *ages), "s"),
        Measure("depth", _middle(taken, depths), "m"),
        Measure("holes", 100 * holes, "%"),
        Measure("late ones", sum(each > _SLOW * usual for each in times), ""),
    ]


def _middle(taken: Sequence[Taken], depths: Sequence[Sequence[int]]) -> float:
    """Median of what there is of depth, metres; 0 if there is none."""
    seen = [value for row in depths for value in row if value]
    return share(seen, 0.5) * taken[0].picture.depth_unit


def _wrong_times(
    name: str, taken: Sequence[Taken], measures: Sequence[Measure]
) -> Optional[Outcome]:
    old = sum(each.asked - each.picture.stamp > STALE for each in taken)
    stamps = [each.picture.stamp for each in taken]
    standing = sum(two <= one for one, two in zip(stamps, stamps[1:]))
    seen = [(each.picture.depth, each.picture.rgb) for each in taken]
    same = sum(one == two for one, two in zip(seen, seen[1:]))
    remedy = "Let the driver wait for a picture that was taken after the call, with its own stamp."
    if old >= _OFTEN:
        text = f"{old} of {len(taken)} pictures were over {STALE} s old when they were asked for."
        return failed(name, "stale frames", text, remedy, *measures)
    if standing >= _OFTEN:
        text = f"{standing} of {len(taken)} pictures have no later stamp than the one before."
        return failed(name, "stale frames", text, remedy, *measures)
    if same == len(taken) - 1 and len(set(_depths(taken[0].picture))) > 1:
        text = "All pictures are the same to the last bit, though their stamps differ."
        return failed(name, "stale frames", text, remedy, *measures)
    return None


def _wrong_depths(
    name: str,
    taken: Sequence[Taken],
    depths: Sequence[Sequence[int]],
    measures: Sequence[Measure],
) -> Outcome:
    middle, holes = _middle(taken, depths), measures[3].value / 100
    if not middle:
        text = "The pictures have no depth at all."
        return failed(name, "no depth", text, "Look whether the camera is covered.", *measures)
    if _NEAR <= middle / 1000 <= _FAR:
        text = f"The depth is {middle:.0f} m in the middle, which would be right in millimetres."
        remedy = "Correct the driver's depth_unit: metres that one step stands for."
        return failed(name, "depth in millimetres", text, remedy, *measures)
    if not _NEAR <= middle <= _FAR:
        text = f"The depth is {middle:.4g} m in the middle, which no table's camera sees."
        return failed(name, "wrong depth unit", text, "Correct the driver's depth_unit.", *measures)
    if holes > _HOLES:
        text = f"{100 * holes:.0f} % of the pixels have no depth."
        remedy = "Register depth to the colour picture; look at light, distance and exposure."
        return failed(name, "holes", text, remedy, *measures)
    return passed(name, "Pictures are fresh and whole, with depth in metres.", *measures)
