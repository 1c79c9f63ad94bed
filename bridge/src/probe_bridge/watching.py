"""Looks at an arm that moves: whether it keeps to its plan, and its points to their boxes."""

from __future__ import annotations

from typing import Tuple

from probe_bridge.config import Config
from probe_bridge.driver import Reading
from probe_bridge.errors import BridgeError
from probe_bridge.planning import stray_point
from probe_bridge.trajectory import Trajectory

STALE = 0.3
"""Seconds after which measured angles are too old to move by."""

LATE = 3.0
"""Seconds by which an arm may arrive after its plan."""

_OUT = 0.01
"""Metres by which a measured point may be outside its box: arms don't follow exactly."""

_LOOKS = 4


class Watch:
    """One motion's checks; each raises BridgeError.

    Args:
        trajectory: The plan.
        config: Whose limits count.
    """

    def __init__(self, trajectory: Trajectory, config: Config) -> None:
        self._trajectory = trajectory
        self._config = config

    def check(self, reading: Reading, started: float, now: float) -> None:
        """Compare measured angles with the plan; times by the robot's clock, seconds.

        Raises:
            BridgeError: "fault" (old angles), "outside" or "blocked".
        """
        if now - reading.stamp > STALE:
            raise BridgeError("fault", f"The joint angles are {now - reading.stamp:.2f} s old.")
        stray = stray_point(self._config.chain.watched(reading.joints), self._config, _OUT)
        if stray:
            raise BridgeError("outside", f"On the way, {stray}.", "Bring the arm back by hand.")
        self._check_trail(reading, reading.stamp - started)
        if now - started > self._trajectory.duration + LATE:
            raise BridgeError("blocked", f"The arm did not arrive within {LATE:.0f} s of its plan.")

    def check_arrived(self, reading: Reading) -> None:
        """Raise "blocked" unless the arm is at the plan's end."""
        self._check_trail(reading, self._trajectory.duration + self._config.delay)

    def _check_trail(self, reading: Reading, time: float) -> None:
        """A joint may be anywhere the plan was in the last moments, and a little beside."""
        past = [time - self._config.delay * i / _LOOKS for i in range(_LOOKS + 1)]
        plans = [self._trajectory.at(moment)[0] for moment in past]
        for number, joint in enumerate(self._config.chain.joints):
            angle = reading.joints[number]
            low, high = _span(tuple(plan[number] for plan in plans))
            off = max(low - angle, angle - high)
            if off > self._config.trail:
                text = f"{joint.name} is {off:.3f} rad from its plan; the arm was stopped."
                raise BridgeError("blocked", text, "Look what holds it back.")


def _span(values: Tuple[float, ...]) -> Tuple[float, float]:
    return min(values), max(values)
