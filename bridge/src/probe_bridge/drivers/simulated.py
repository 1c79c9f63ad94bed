"""An arm that is only computed, over a table that is only painted: for tests and for practice."""

from __future__ import annotations

import struct
import threading
import time
from typing import Optional, Tuple

from probe_bridge.config import Config
from probe_bridge.curve import Row
from probe_bridge.driver import Reading, Shot
from probe_bridge.fields import Fields
from probe_bridge.trajectory import Trajectory

_UNIT = 1e-4
_HAND_SPEED = 0.1


class SimulatedDriver:
    """Follows a motion exactly, by the clock. Pictures are flat.

    Args:
        config: Its option "distance" is the depth of every pixel, metres.
    """

    def __init__(self, config: Config) -> None:
        options = Fields(config.options, "config.driver")
        self._depth = round(options.number("distance", 0.01, 6.5) / _UNIT)
        options.end()
        self._cameras = config.cameras
        self._lock = threading.Lock()
        self._rest: Row = config.home
        self._motion: Optional[Tuple[Trajectory, float]] = None
        self._hand = config.max_opening
        self._grip: Optional[Tuple[float, float]] = None

    def joints(self) -> Reading:
        with self._lock:
            now = time.monotonic()
            return Reading(self._at(now), now)

    def opening(self) -> float:
        with self._lock:
            return self._hand_at(time.monotonic())

    def frame(self, camera: str, rgb: bool) -> Shot:
        width, height = self._cameras[camera].width, self._cameras[camera].height
        depth = struct.pack("<H", self._depth) * (width * height)
        colour = bytes((120, 110, 100)) * (width * height) if rgb else None
        return Shot(width, height, depth, _UNIT, colour, time.monotonic())

    def start(self, trajectory: Trajectory) -> None:
        with self._lock:
            self._motion = (trajectory, time.monotonic())

    def poll(self) -> bool:
        with self._lock:
            now = time.monotonic()
            if self._motion and now - self._motion[1] >= self._motion[0].duration:
                self._settle(now)
            return self._motion is None

    def start_grip(self, opening: float) -> None:
        with self._lock:
            now = time.monotonic()
            self._hand = self._hand_at(now)
            self._grip = (opening, now)

    def poll_grip(self) -> bool:
        with self._lock:
            return self._grip is None or self._hand_at(time.monotonic()) == self._grip[0]

    def stop(self) -> None:
        with self._lock:
            now = time.monotonic()
            self._settle(now)
            self._hand, self._grip = self._hand_at(now), None

    def close(self) -> None:
        self.stop()

    def _settle(self, now: float) -> None:
        self._rest, self._motion = self._at(now), None

    def _at(self, now: float) -> Row:
        if self._motion is None:
            return self._rest
        trajectory, started = self._motion
        return trajectory.at(now - started)[0]

    def _hand_at(self, now: float) -> float:
        if self._grip is None:
            return self._hand
        goal, started = self._grip
        reach = _HAND_SPEED * (now - started)
        return min(goal, self._hand + reach) if goal > self._hand else max(goal, self._hand - reach)
