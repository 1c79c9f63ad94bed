"""A motion that would not end by itself for a while, and how it comes to rest."""

from __future__ import annotations

import math
import time
from typing import Callable, List, NamedTuple

from probe_bridge.client import RobotClient
from probe_bridge.curve import Row
from probe_bridge.errors import BridgeError

_LASTS = 4.0
"""Seconds that the motion lasts if nothing stops it."""

_SWING = 0.15
_ROOM = 0.05
_UNDER_WAY = 0.04
"""Radians to each side; radians that are kept from the joint's limits; and after which it moves."""

_BEGINS = 10.0
"""Seconds in which it must begin: the bridge first checks all of the path, on a slow computer."""

_KEPT = 0.45
"""Share of a joint's acceleration that speeding up and slowing down may use (see timing.py)."""

_STILL = 0.002
"""Radians between two looks below which the arm rests."""

_PERIOD = 0.04
_LOOKS = 8
"""In so many looks one after another the arm must rest: where it turns back, it is slow as well."""


class Halt(NamedTuple):
    """How an arm came to rest: after how many seconds (inf if not), and radians on the way."""

    seconds: float
    rolled: float


def swing(client: RobotClient) -> List[Row]:
    """A path that turns the hand to and fro where it is, for some seconds."""
    start, joint = client.joints(), client.description.joints[-1]
    low = max(start[-1] - _SWING, joint.lower + _ROOM)
    high = min(start[-1] + _SWING, joint.upper - _ROOM)
    once = 2 * math.sqrt((high - low) / (_KEPT * joint.acceleration))
    times = math.ceil(_LASTS / once)
    ends = [(high, low)[k % 2] for k in range(times + 1)]
    return [start, *((*start[:-1], end) for end in ends)]


def begin_swing(client: RobotClient) -> None:
    """Begin it, and return once the hand turns; the caller then has a lease's time.

    Raises:
        BridgeError: The bridge refuses it, or nothing turned.
    """
    path = swing(client)
    motion, ends = client.begin(path), time.monotonic() + _BEGINS
    while abs(client.joints()[-1] - path[0][-1]) < _UNDER_WAY:
        motion.renew()
        if motion.reply.came():
            _ = motion.reply.result
        if time.monotonic() > ends:
            client.stop()
            raise BridgeError("fault", f"The hand did not begin to turn within {_BEGINS:.0f} s.")
        time.sleep(_PERIOD)
    motion.renew()


def rest(client: RobotClient, since: float, within: float, meanwhile: Callable[[], None]) -> Halt:
    """Look at the arm until it rests, or for so many seconds since a moment.

    Args:
        client: Connected.
        since: The moment, time.monotonic().
        within: Seconds to look for.
        meanwhile: Is called between two looks.
    """
    last, rolled, still, halted = client.joints(), 0.0, 0, since
    while time.monotonic() < since + within:
        meanwhile()
        time.sleep(_PERIOD)
        now = client.joints()
        step = max(abs(a - b) for a, b in zip(now, last))
        rolled, last = rolled + step, now
        if step > _STILL:
            still, halted = 0, time.monotonic()
        else:
            still += 1
        if still == _LOOKS:
            return Halt(halted - since, rolled)
    return Halt(math.inf, rolled)
