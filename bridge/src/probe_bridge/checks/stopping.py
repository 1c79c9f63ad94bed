"""Whether the arm really stops: measured in its joints, not believed of the bridge."""

from __future__ import annotations

import math
import time
from typing import Callable, Optional, Tuple

from probe_bridge.checks.outcome import Measure, Outcome, failed, passed, skipped
from probe_bridge.checks.swing import begin_swing, rest
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError
from probe_bridge.lease import LEASE

STOP, WATCHDOG, CUT = "stop", "watchdog", "cut link"

_BY = 0.5
"""Seconds that an arm may take to rest."""

_TRIES = 3
_LONGER = 1.5
_ENDS = 20.0
"""Seconds for which an arm that does not stop is looked at; and until its motion ends by itself."""


def check_stop(client: RobotClient) -> Outcome:
    """Turn the hand, ask it to stop halfway, and see when it rests."""
    reason = _cannot_begin(client)
    if reason:
        return skipped(STOP, reason)
    asked = time.monotonic()
    client.stop()
    return _judged(STOP, client, client, asked, "a stop was asked for", 0.0)


def check_watchdog(client: RobotClient) -> Outcome:
    """Turn the hand and renew no lease: it has to stop by itself."""
    reason = _cannot_begin(client)
    if reason:
        return skipped(WATCHDOG, reason)
    asked = time.monotonic()
    return _judged(WATCHDOG, client, None, asked, "the last lease", LEASE)


def check_cut(client: RobotClient, again: Callable[[], RobotClient]) -> Tuple[Outcome, RobotClient]:
    """Turn the hand and leave; a new client sees whether the arm rests.

    Args:
        client: Is closed.
        again: Connects once more.

    Returns:
        What was found, and the new client.
    """
    reason = _cannot_begin(client)
    if reason:
        return skipped(CUT, reason), client
    asked = time.monotonic()
    client.close()
    client = again()
    return _judged(CUT, client, client, asked, "the connection closed", 0.0), client


def _cannot_begin(client: RobotClient) -> str:
    """Why the hand can't be turned; "" if it turns now.

    A lease that lapses before it turns tells of a network or a computer that stalled: once more.
    """
    for left in reversed(range(_TRIES)):
        try:
            begin_swing(client)
        except BridgeError as error:
            if error.kind == "lost":
                raise
            if error.kind != "lease" or not left:
                return f"The hand can't be turned here: {error}"
            time.sleep(_BY)
        else:
            break
    return ""


def _judged(
    check: str,
    client: RobotClient,
    leases: Optional[RobotClient],
    asked: float,
    why: str,
    allowed: float,
) -> Outcome:
    renew = _renewing(leases) if leases else _nothing
    halt = rest(client, asked, allowed + _LONGER, renew)
    rolled = Measure("turned on by", halt.rolled, "rad")
    if halt.seconds <= allowed + _BY:
        text = f"The arm rested {halt.seconds:.2f} s after {why}."
        return passed(check, text, Measure("rest after", halt.seconds, "s"), rolled)
    remedy = "Let the driver's stop() halt the controller itself, and use the emergency stop now."
    if math.isinf(halt.seconds):
        rest(client, asked, _ENDS, _nothing)
        text = f"The arm still moved {allowed + _LONGER:.1f} s after {why}."
        return failed(check, "no stop", text, remedy, rolled)
    text = f"The arm rested only {halt.seconds:.2f} s after {why}."
    return failed(
        check, "slow stop", text, remedy, Measure("rest after", halt.seconds, "s"), rolled
    )


def _renewing(client: RobotClient) -> Callable[[], None]:
    """Renews what moves; it must stop all the same."""
    renewal = client.renewal()

    def renew() -> None:
        renewal.renew()
        renewal.look(0.0)

    return renew


def _nothing() -> None:
    """Nothing is done between two looks."""
