"""Whether every message is answered, and how soon."""

from __future__ import annotations

import time
from pathlib import Path
from typing import List, Optional, Sequence

from probe_bridge.checks.clock import ClockWatch, Look
from probe_bridge.checks.outcome import Measure, Outcome, failed, passed
from probe_bridge.command_log import NOWHERE, CommandLog
from probe_bridge.errors import BridgeError
from probe_bridge.lease import LEASE
from probe_bridge.link import Link, Reply
from probe_bridge.wire import VERSION

MESSAGES = "messages"

_COUNT = 300
"""Calls that are made: of 1 % lost messages, 95 % of such checks would notice one."""

_PATIENCE = 1.0
_LATE = 3.0
"""Seconds after the last call in which what is only late may still come."""

_ENOUGH = 3
_SLOWEST = LEASE / 2
"""Seconds of an answer beyond which two lost leases would stop the robot."""


def check_messages(
    address: str, token: str, certificate: Optional[Path], clock: ClockWatch
) -> Outcome:
    """Call often, count the answers, and time them; the clock hears what they say of the time."""
    try:
        link = Link(address, token, certificate, CommandLog(NOWHERE))
        try:
            return _checked(link, clock)
        finally:
            link.close()
    except BridgeError as error:
        return failed(MESSAGES, "no link", str(error), error.remedy or "Look at the bridge's log.")


def _checked(link: Link, clock: ClockWatch) -> Outcome:
    calls: List[Reply] = [link.send("hello", version=VERSION)]
    missing = [] if calls[0].came(_PATIENCE) else [calls[0]]
    seconds: List[float] = []
    for number in range(_COUNT):
        before = time.monotonic()
        do = ("joints", "state", "lease")[number % 3]
        reply = link.send(do, seen=0.0) if do == "lease" else link.send(do)
        calls.append(reply)
        if reply.came(_PATIENCE):
            after = time.monotonic()
            seconds.append(after - before)
            if "clock" in reply.result:
                clock.add(Look(before, float(reply.result["clock"]), after))
        else:
            missing.append(reply)
        if len(missing) == _ENOUGH:
            break
    lost = _lost(missing)
    return _judged(len(calls), lost, len(missing) - lost, seconds)


def _lost(missing: Sequence[Reply]) -> int:
    """How many answers have not come even after a while."""
    end = time.monotonic() + _LATE
    return sum(not reply.came(max(0.0, end - time.monotonic())) for reply in missing)


def _judged(calls: int, lost: int, late: int, seconds: Sequence[float]) -> Outcome:
    measures = (Measure("calls", calls, ""), Measure("unanswered", lost, ""), *_times(seconds))
    if lost:
        text = f"{lost} of {calls} calls were never answered, and no error came."
        remedy = "Look for what swallows messages: a proxy between, a driver that hangs, the log."
        return failed(MESSAGES, "silent drop of messages", text, remedy, *measures)
    if late or share(seconds, 0.95) > _SLOWEST:
        text = f"Answers take over {_SLOWEST} s too often; motions will stop for want of a lease."
        remedy = "Use a cable, or a computer with less to do."
        return failed(MESSAGES, "slow link", text, remedy, *measures)
    return passed(MESSAGES, f"All {calls} calls were answered.", *measures)


def _times(seconds: Sequence[float]) -> Sequence[Measure]:
    if not seconds:
        return ()
    return (
        Measure("median", 1000 * share(seconds, 0.5), "ms"),
        Measure("95 %", 1000 * share(seconds, 0.95), "ms"),
    )


def share(values: Sequence[float], part: float) -> float:
    """The value below which a part of the values lies, 0 to 1; 0 if there is none."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))] if ordered else 0.0
