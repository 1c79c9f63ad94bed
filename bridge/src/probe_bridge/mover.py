"""Carries out one motion at a time and stops it as soon as anything is wrong."""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from typing import Callable, List, Optional, TypeVar

from probe_bridge.config import Config
from probe_bridge.curve import Row
from probe_bridge.driver import Driver, Reading
from probe_bridge.errors import BridgeError
from probe_bridge.lease import FRESH, LEASE, Lease
from probe_bridge.planning import plan
from probe_bridge.watching import Watch

_T = TypeVar("_T")
_LOG = logging.getLogger("probe_bridge")

TICK = 0.01
"""Seconds between two looks at a motion."""

_TRIES = 10

GRIP_TIME = 10.0
"""Seconds after which a hand that is still moving is stopped."""


class Mover:
    """Moves the arm and the hand. `halt` and `renew` may come from any thread, at any moment.

    Args:
        driver: Of the robot.
        config: Whose limits count.
    """

    def __init__(self, driver: Driver, config: Config) -> None:
        self._driver = driver
        self._config = config
        self._lease = Lease(time.monotonic)
        self._lock = threading.Lock()
        self._busy = False
        self._halted: Optional[BridgeError] = None
        self._closed = threading.Event()
        # A thread of its own, so that the lease counts even while the driver answers nothing.
        self._watchdog = threading.Thread(target=self._watch_lease, name="lease", daemon=True)
        self._watchdog.start()

    def close(self) -> None:
        """Stop what moves, for good."""
        self.halt("stopped", "The bridge is closing.")
        self._closed.set()
        self._watchdog.join()

    @property
    def busy(self) -> bool:
        return self._busy

    @property
    def lease_left(self) -> float:
        """Seconds for which the robot may still move; 0 if nothing moves."""
        return max(0.0, self._lease.left) if self._busy else 0.0

    def renew(self, seen: float) -> None:
        """Let what moves go on for another while, unless the renewal was long on its way.

        Args:
            seen: The robot's clock as the client last heard it, seconds.
        """
        if self._lease.age(seen) <= FRESH:
            self._lease.renew()

    def claim(self, seen: float) -> None:
        """Reserve the robot for the next follow, home or grip; what is halted from now on stays so.

        Args:
            seen: The robot's clock as the client last heard it, seconds.

        Raises:
            BridgeError: "busy", or "late".
        """
        age = self._lease.age(seen)
        if age > FRESH:
            text = f"The request builds on a reply of {age:.1f} s ago; {FRESH} s at most."
            raise BridgeError("late", text, "Look at the network, and ask again.")
        with self._lock:
            if self._busy:
                raise BridgeError("busy", "The robot is still moving.", "Wait, or stop it.")
            self._busy = True
            self._halted = None
            self._lease.renew()

    def halt(self, kind: str, text: str) -> None:
        """Stop arm and hand now, and let the motion's reply say why.

        Raises:
            BridgeError: "fault"; the driver can't stop them.
        """
        with self._lock:
            if self._halted is None:
                self._halted = BridgeError(kind, text)
            self._stop()

    def follow(self, path: List[Row], speed: float) -> Row:
        """Move through a claimed path; return where the arm came to rest.

        Args:
            path: Waypoints, radians.
            speed: Share of the speed limits that may be used, above 0 and at most 1.

        Raises:
            BridgeError: "refused", "blocked", "outside", "lease", "stopped" or "fault".
        """
        return self._claimed(lambda: self._follow(path, speed))

    def home(self, speed: float) -> Row:
        """Move straight to the home position; arguments and errors as of follow."""
        return self._claimed(lambda: self._follow([self._now().joints, self._config.home], speed))

    def grip(self, opening: float) -> float:
        """Move the hand towards an opening, metres; return the opening that it reached."""
        return self._claimed(lambda: self._grip(opening))

    def _follow(self, path: List[Row], speed: float) -> Row:
        trajectory = plan(path, self._now().joints, self._config).slowed(1 / speed)
        watch = Watch(trajectory, self._config)
        self._begin(lambda: self._driver.start(trajectory))
        started = time.monotonic()
        while not self._driver.poll():
            self._check_halted()
            watch.check(self._now(), started, time.monotonic())
            time.sleep(TICK)
        self._check_halted()
        reading = self._now()
        watch.check_arrived(reading)
        return reading.joints

    def _grip(self, opening: float) -> float:
        self._begin(lambda: self._driver.start_grip(opening))
        started = time.monotonic()
        while not self._driver.poll_grip():
            self._check_halted()
            if time.monotonic() - started > GRIP_TIME:
                raise BridgeError("fault", f"The hand still moves after {GRIP_TIME:.0f} s.")
            time.sleep(TICK)
        self._check_halted()
        return self._driver.opening()

    def _begin(self, start: Callable[[], None]) -> None:
        """Start, unless something has halted the motion since it was claimed."""
        with self._lock:
            if self._halted:
                raise self._halted
            start()

    def _check_halted(self) -> None:
        if self._halted:
            raise self._halted

    def _watch_lease(self) -> None:
        while not self._closed.wait(TICK):
            if self._busy and self._halted is None and self._lease.left <= 0:
                with contextlib.suppress(BridgeError):  # it has been logged
                    self.halt("lease", f"No lease came for {LEASE} s; the robot was stopped.")

    def _stop(self) -> None:
        """Stop the robot; try again if the driver fails.

        Raises:
            BridgeError: "fault"; the driver fails again and again.
        """
        for left in reversed(range(_TRIES)):
            try:
                self._driver.stop()
                return
            except Exception as error:
                _LOG.critical("The robot could not be stopped: %r", error)
                if not left:
                    text = f"The robot could not be stopped: {error!r}."
                    raise BridgeError("fault", text, "Use its emergency stop.") from error
            time.sleep(TICK)

    def _now(self) -> Reading:
        return self._driver.joints()

    def _claimed(self, work: Callable[[], _T]) -> _T:
        """Do claimed work; if it doesn't succeed, stop the robot before anyone hears of it."""
        try:
            return work()
        except BridgeError as error:
            if error.kind != "refused":
                self._stop()
            raise
        except Exception as error:
            self._stop()
            if self._halted:  # a driver may call a motion that was stopped a failure
                raise self._halted from error
            raise BridgeError("fault", f"The driver failed: {error!r}.") from error
        finally:
            self._busy = False
