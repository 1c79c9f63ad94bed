"""A station that a person can stop at any moment."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager

from probe.errors import ProbeError, StoppedByPerson
from probe.station.emergency_stop import EmergencyStop
from probe.station.station import Arm, Hand, Station
from probe.types import Array, Frame


class Stoppable:
    """A Station of one episode; once its stop has been pressed every method raises StoppedByPerson.

    A stop ends the episode as a fault, whatever the agent was about to do, an answer included, and
    whether or not it has been released since: nobody knows how the table would have looked without
    it.

    Args:
        station: The one that acts.
        stop: A person's.
    """

    def __init__(self, station: Station, stop: EmergencyStop) -> None:
        self.arm: Arm = station.arm
        self.hand: Hand = station.hand
        self._station = station
        self._stop = stop
        self._presses = stop.presses

    def observe(self, *, rgb: bool) -> Frame:
        """As Station."""
        with self._watched():
            return self._station.observe(rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """As Station."""
        with self._watched():
            return self._station.look_into_basket(rgb=rgb)

    def joints(self) -> Array:
        """As Station."""
        with self._watched():
            return self._station.joints()

    def follow(self, path: Array) -> bool:
        """As Station."""
        with self._watched():
            return self._station.follow(path)

    def grip(self, opening: float) -> float:
        """As Station."""
        with self._watched():
            return self._station.grip(opening)

    def wait(self, seconds: float) -> None:
        """As Station."""
        with self._watched():
            self._station.wait(seconds)

    @contextmanager
    def _watched(self) -> Generator[None]:
        """Whatever a stop makes of a call, its error or its result, the stop is what is told."""
        self._check()
        try:
            yield
        except ProbeError:
            self._check()
            raise
        self._check()

    def _check(self) -> None:
        self._stop.check()
        if self._stop.presses != self._presses:
            raise StoppedByPerson("A person stopped the robot in this episode, and released it.")
