"""The skill that shoves a thing across the table with the closed gripper. Knows no names."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from probe.manipulation.looking import still_there, tracked
from probe.manipulation.stroke import Stroke, stroke
from probe.station.station import Station
from probe.types import Array, Frame, Vector3

Direction = Literal["up", "down", "left", "right"]
"""In the picture of the fixed camera."""

PushStatus = Literal["pushed", "short", "unmoved", "no_space", "unreachable", "blocked"]
"""What came of a push:

pushed: The tool swept as far as was asked for.
short: It swept less: the basket or the arm's reach ended it.
unmoved: It swept, but the thing looks as it did.
no_space: There is no free spot behind the thing where the tool could come down.
unreachable: The arm can't follow any such path.
blocked: Something stopped the arm.
"""

SHORTEST, LONGEST = 0.03, 0.20
"""Distances that may be asked for, metres."""

STROKES = 3
"""Sweeps that one push may take: what rolls, tips or turns aside is pushed on from where it is."""

_ALONG = {
    "right": np.array([1.0, 0.0, 0.0]),
    "left": np.array([-1.0, 0.0, 0.0]),
    "up": np.array([0.0, 1.0, 0.0]),
    "down": np.array([0.0, -1.0, 0.0]),
}
_STAYED = 0.9
_SHORT = 0.01
_FAR_ENOUGH = 0.8
_LEAST = 0.02


@dataclass(frozen=True, eq=False)
class PushResult:
    """What came of a push.

    Attributes:
        status: See PushStatus.
        frame: The table afterwards, without colours.
        swept: How far the tool came along the push from where the thing was, metres.
        moved: How far the thing went that way, by its looks, metres; None if lost from sight.
        strokes: Sweeps that were begun.
    """

    status: PushStatus
    frame: Frame
    swept: float = 0.0
    moved: float | None = 0.0
    strokes: int = 0


def push(
    station: Station,
    frame: Frame,
    mask: Array,
    direction: Direction,
    distance_m: float,
    basket: Vector3,
) -> PushResult:
    """Push what a mask shows in a direction of the picture.

    The arm starts and ends parked. What it touches stays as physics leaves it. A thing that has
    fallen well behind is pushed on from where it lies, if it can be told by its shape.

    Args:
        station: The arm, camera and table.
        frame: The table as it is now.
        mask: Which pixels show the thing, bool, shape (h, w).
        direction: Of the fixed camera's picture.
        distance_m: SHORTEST to LONGEST.
        basket: Middle of the basket's floor, which nothing is pushed into.

    Raises:
        ValueError: The distance lies outside that range.
    """
    if not SHORTEST <= distance_m <= LONGEST:
        raise ValueError(f"a push goes {SHORTEST} to {LONGEST} m, not {distance_m} m")
    along = _ALONG[direction]
    result, place = PushResult("no_space", frame), mask
    while result.strokes < STROKES and result.moved is not None:
        left = distance_m - result.moved
        if left < max(_LEAST, (1 - _FAR_ENOUGH) * distance_m):
            break
        done = stroke(station, result.frame, place, along, left, basket)
        if done.end in ("no_space", "unreachable"):
            return result if result.strokes else PushResult(done.end, done.frame)
        found = tracked(result.frame, done.frame, place, along * done.swept)
        moved = None if found is None else result.moved + float(found.shift @ along)
        swept = max(result.swept, result.moved + done.swept)
        status = _status(done, swept, distance_m)
        result = PushResult(status, done.frame, swept, moved, result.strokes + 1)
        place = place if found is None else found.mask
    if result.status == "pushed" and still_there(frame, result.frame, mask) > _STAYED:
        return replace(result, status="unmoved")
    return result


def _status(done: Stroke, swept: float, asked: float) -> PushStatus:
    if swept > asked - _SHORT:
        return "pushed"
    return "blocked" if done.end == "blocked" else "short"
