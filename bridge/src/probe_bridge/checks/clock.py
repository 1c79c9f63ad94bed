"""Whether the robot's clock runs as the client's does, all the time that checks take."""

from __future__ import annotations

import time
from typing import List, NamedTuple

from probe_bridge.checks.outcome import Measure, Outcome, failed, passed, skipped
from probe_bridge.client import RobotClient

CLOCK = "clock"

_STEP = 0.02
"""Seconds by which two looks may contradict each other: clocks are read a little late."""

_DRIFT = 1e-3
"""Most drift, seconds in a second; quartz is a hundred times as good."""

_SHORTEST = 2.0
"""Seconds of looking below which nothing is said about drift."""


class Look(NamedTuple):
    """The robot's clock, and between which times by the client's it was read, seconds."""

    before: float
    robot: float
    after: float


class ClockWatch:
    """Remembers what the robot's clock said and when."""

    def __init__(self) -> None:
        self._looks: List[Look] = []

    def look(self, client: RobotClient) -> float:
        """The robot's clock now, seconds; raises BridgeError."""
        before = time.monotonic()
        robot = float(client.state()["clock"])
        self.add(Look(before, robot, time.monotonic()))
        return robot

    def add(self, look: Look) -> None:
        """Remember a look that was made otherwise."""
        self._looks.append(look)

    def outcome(self) -> Outcome:
        """What all looks together say."""
        return judged(self._looks)


def judged(looks: List[Look]) -> Outcome:
    """Whether the clock jumped or drifted between looks."""
    if len(looks) < 2:
        return skipped(CLOCK, "The clock was not read often enough.")
    seen = looks[-1].after - looks[0].before
    measures = [Measure("looks", len(looks), ""), Measure("over", seen, "s")]
    jump = max((_jump(one, two) for one, two in zip(looks, looks[1:])), key=abs)
    if jump:
        text = f"The robot's clock jumped by {jump:+.3f} s between two looks."
        remedy = "Let the bridge use a monotonic clock, for pictures and joints as well."
        return failed(CLOCK, "clock jump", text, remedy, Measure("jump", jump, "s"), *measures)
    if seen > _SHORTEST:
        drift = _beyond(looks[0], looks[-1]) / seen
        measures.append(Measure("drift", 1e6 * _middle(looks[0], looks[-1]) / seen, "ppm"))
        if abs(drift) > _DRIFT:
            text = f"The robot's clock drifts by {1000 * drift:+.1f} ms in a second."
            return failed(CLOCK, "clock drift", text, "Let its computer use NTP.", *measures)
    return passed(CLOCK, "The robot's clock runs as this computer's does.", *measures)


def _jump(one: Look, two: Look) -> float:
    """Seconds that the clock moved beyond what passed here, drift and slack allowed for; or 0."""
    allowed = _STEP + _DRIFT * (two.after - one.before)
    beyond = _beyond(one, two)
    return beyond if abs(beyond) > allowed else 0.0


def _beyond(one: Look, two: Look) -> float:
    """Seconds that the clock surely gained (or lost, below 0) between two looks."""
    passed_there = two.robot - one.robot
    least, most = two.before - one.after, two.after - one.before
    return max(0.0, passed_there - most) + min(0.0, passed_there - least)


def _middle(one: Look, two: Look) -> float:
    """Seconds that the clock most likely gained."""
    return (two.robot - one.robot) - (two.before + two.after - one.before - one.after) / 2
