"""The skill that shoves a thing across the table with the closed gripper. Knows no names."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from probe.manipulation.looking import still_there
from probe.manipulation.recognition import found_again
from probe.manipulation.stroke import Stroke, stroke
from probe.manipulation.terrain import lifted
from probe.scene.setup import Setup
from probe.station.colours import paintable
from probe.station.station import Station
from probe.types import Array, Frame, Pose

Direction = Literal["up", "down", "left", "right"]
"""In the picture of the fixed camera."""

PushStatus = Literal["pushed", "short", "unmoved", "no_space", "unreachable", "blocked"]
"""What came of a push:

pushed: The tool swept, or the thing went, as far as was asked for.
short: It swept less: the basket or the arm's reach ended it.
unmoved: It swept, but the thing looks as it did.
no_space: There is no free spot, behind the thing or on it, where the tool could come down.
unreachable: The arm can't follow any such path.
blocked: Something stopped the arm.
"""

SHORTEST, LONGEST = 0.03, 0.20
"""Distances that may be asked for, metres."""

STROKES = 6
"""Sweeps that one push may take: what rolls, tips or turns aside is pushed on from where it is."""

ALONG: dict[Direction, Array] = {
    "left": np.array([-1.0, 0.0, 0.0]),
    "right": np.array([1.0, 0.0, 0.0]),
    "up": np.array([0.0, 1.0, 0.0]),
    "down": np.array([0.0, -1.0, 0.0]),
}
"""Unit vectors in the world, shape (3,), of a push's directions."""

_STAYED = 0.9
_SHORT = 0.01
_FAR_ENOUGH = 0.8
_LEAST = 0.008
_IN_VAIN = 0.3
_REAR_PERCENT = 5.0


@dataclass(frozen=True, eq=False)
class PushResult:
    """What came of a push.

    Attributes:
        status: See PushStatus.
        frame: The table afterwards.
        swept: How far the tool came along the push from where the thing was, metres.
        moved: How far the thing went that way, by its looks, metres; None if lost from viewpoint.
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
    setup: Setup,
) -> PushResult:
    """Push what a mask shows in a direction of the picture.

    The arm starts and ends parked. What it touches stays as physics leaves it. A thing that has
    fallen well behind is pushed on from where it lies, if it can be told by its shape and colours.

    Args:
        station: The arm, camera and table.
        frame: The table as it is now.
        mask: Which pixels show the thing, bool, shape (h, w).
        direction: Of the fixed camera's picture.
        distance_m: SHORTEST to LONGEST.
        setup: The table's; nothing is pushed into its basket.

    Raises:
        ValueError: The distance lies outside that range.
    """
    if not SHORTEST <= distance_m <= LONGEST:
        raise ValueError(f"a push goes {SHORTEST} to {LONGEST} m, not {distance_m} m")
    along = ALONG[direction]
    result, track, end = PushResult("no_space", frame), _Track(mask), distance_m
    while result.strokes < STROKES and track.mask is not None:
        left = end - track.gone
        # What was stopped is worth another try even for the last bit.
        rest = 0.0 if result.status == "blocked" else (1 - _FAR_ENOUGH) * distance_m
        if left < max(_LEAST, rest):
            break
        before = paintable(station, result.frame)
        done = stroke(station, before, track.mask, along, left, setup, track.in_vain)
        if done.end in ("no_space", "unreachable"):
            return result if result.strokes else PushResult(done.end, done.frame)
        swept = max(result.swept, track.gone + done.swept)
        # Once a part is out of the picture, how near the basket it is can't be seen any more.
        end = min(end, track.gone + done.room)
        after, track = _follow(station, track, before, done, along)
        moved = None if track.mask is None else track.gone
        status = _status(done, max(swept, moved or 0.0), distance_m)
        result = PushResult(status, after, swept, moved, result.strokes + 1)
    if result.status == "pushed" and still_there(frame, result.frame, mask) > _STAYED:
        return replace(result, status="unmoved")
    return result


@dataclass(frozen=True, eq=False)
class _Track:
    """Where a thing has got to.

    Attributes:
        mask: Which pixels show it; None if nothing that could be it is seen.
        gone: How far it went along the push, metres.
        in_vain: Starts from which it was pushed and hardly moved.
    """

    mask: Array | None
    gone: float = 0.0
    in_vain: tuple[Pose, ...] = ()


def _follow(
    station: Station, track: _Track, before: Frame, done: Stroke, along: Array
) -> tuple[Frame, _Track]:
    """The table and where the thing is after a stroke; looked at in colour if shape won't do."""
    assert track.mask is not None
    after, way = done.frame, along * done.swept
    after, found = found_again(station, before, after, track.mask, way)
    if found is None:
        return after, _Track(None, track.gone)
    step = float(found.shift @ along)
    if _at_border(found.mask):
        step = _rear(after, found.mask, along) - _rear(before, track.mask, along)
    in_vain = (*track.in_vain, *done.starts) if step < _IN_VAIN * done.swept else ()
    return after, _Track(found.mask, track.gone + step, in_vain)


def _at_border(mask: Array) -> bool:
    """Whether a part may lie outside the picture, so that its middle isn't known."""
    inner = mask.copy()
    inner[1:-1, 1:-1] = False
    return bool(inner.any())


def _rear(frame: Frame, mask: Array, along: Array) -> float:
    """Where a thing begins along a direction, metres; seen even if its front left the picture."""
    return float(np.percentile(lifted(frame, mask) @ along, _REAR_PERCENT))


def _status(done: Stroke, reached: float, asked: float) -> PushStatus:
    if reached > asked - _SHORT:
        return "pushed"
    return "blocked" if done.end == "blocked" else "short"
