"""All people who answer at once: who has a seat, and whose table is cleared for somebody else."""

from __future__ import annotations

import threading
from contextlib import suppress
from pathlib import Path

from probe.interfaces.human.live_episode import Furnish
from probe.interfaces.human.names import name_of
from probe.interfaces.human.session import HumanSession
from probe.interfaces.human.session_store import SessionStore
from probe.interfaces.human.words import NotNow
from probe.tasks.suite import Suite
from probe.types import PictureScale


class SessionManager:
    """Seats by name; a table costs memory, so there are but so many.

    Somebody new gets the seat of whoever has been away longest. Nothing is lost by that: who
    comes back gets the table as it was left.

    Args:
        suite: What is asked.
        out: A folder that was started for it.
        furnish: Opens what a seat's tables need.
        seats: How many there are.
    """

    def __init__(self, suite: Suite, out: Path, furnish: Furnish, seats: int) -> None:
        self._suite = suite
        self._out = out
        self._furnish = furnish
        self._number = seats
        self._lock = threading.Lock()
        self._seats: dict[str, HumanSession] = {}

    @property
    def scale(self) -> PictureScale:
        """Of the suite's pictures, by its first task."""
        return self._suite.tasks[0].scale

    def enter(self, said: str) -> HumanSession:
        """The seat of a person, with a table or one on its way.

        Raises:
            BadName: The name won't do.
            NotNow: All seats are taken by people whose tables are at work.
            BadData: What is kept of them can't be read.
        """
        name = name_of(said)
        with self._lock:
            seat = self._seats.pop(name, None)
            if seat is None:
                self._make_room()
                seat = HumanSession(SessionStore(name, self._suite, self._out), self._furnish)
            self._seats[name] = seat
        if seat.state.over and seat.state.number == 0 and seat.state.doing is None:
            with suppress(NotNow):  # another page of the same person was quicker
                seat.go_on()
        return seat

    def seat(self, said: str) -> HumanSession | None:
        """The seat of a person who is here; None for anybody else."""
        name = name_of(said)
        with self._lock:
            seat = self._seats.pop(name, None)
            if seat is not None:
                self._seats[name] = seat  # the last to have been heard of
        return seat

    def close(self) -> None:
        """Clear all tables once what is going on at them has ended."""
        with self._lock:
            for seat in self._seats.values():
                seat.close()
            self._seats.clear()

    def _make_room(self) -> None:
        if len(self._seats) < self._number:
            return
        idle = [name for name, seat in self._seats.items() if seat.state.doing is None]
        if not idle:
            raise NotNow("All seats are taken at the moment. Try again in a minute.")
        self._seats.pop(idle[0]).close()
