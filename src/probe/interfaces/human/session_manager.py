"""All people who answer at once: who has a seat, and whose table is cleared for somebody else."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path

from probe.interfaces.human.names import name_of
from probe.interfaces.human.practice import PracticeStore
from probe.interfaces.human.session import HumanSession
from probe.interfaces.human.session_store import SessionStore
from probe.interfaces.human.table_places import Furnish
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
        practice: What people may practise on, if anything.
    """

    def __init__(
        self, suite: Suite, out: Path, furnish: Furnish, seats: int, practice: Suite | None = None
    ) -> None:
        self._suite = suite
        self._out = out
        self._furnish = furnish
        self._number = seats
        self._lock = threading.Lock()
        self._practice = practice
        self._seats: dict[tuple[str, bool], HumanSession] = {}
        # Clearing waits for a table that is being set; nobody else is to wait for that.
        self._clearing = ThreadPoolExecutor(1, "clearing")

    @property
    def scale(self) -> PictureScale:
        """Of the suite's pictures, by its first task."""
        return self._suite.tasks[0].scale

    @property
    def practice(self) -> int:
        """How many questions there are to practise on."""
        return len(self._practice.tasks) if self._practice else 0

    def enter(self, said: str, *, practice: bool = False) -> HumanSession:
        """The seat of a person, with a table or one on its way.

        A person has one seat: who goes from practice to the suite gives up the other.

        Args:
            said: The name.
            practice: Whether to practise, which begins anew once all has been practised.

        Raises:
            BadName: The name won't do.
            NotNow: All seats are taken by people whose tables are at work, or there is nothing to
                practise on.
            BadData: What is kept of them can't be read.
        """
        name = name_of(said)
        if practice and self._practice is None:
            raise NotNow("There is nothing to practise on here.")
        with self._lock:
            self._give_up((name, not practice))
            seat = self._seats.pop((name, practice), None)
            if seat is not None and practice and _is_through(seat):
                self._clearing.submit(seat.close)
                seat = None
            if seat is None:
                self._make_room()
                seat = self._new(name, practice=practice)
            self._seats[name, practice] = seat
        if seat.state.over and seat.state.number == 0 and seat.state.doing is None:
            with suppress(NotNow):  # another page of the same person was quicker
                seat.go_on()
        return seat

    def seat(self, said: str, *, practice: bool = False) -> HumanSession | None:
        """The seat of a person who is here; None for anybody else."""
        key = name_of(said), practice
        with self._lock:
            seat = self._seats.pop(key, None)
            if seat is not None:
                self._seats[key] = seat  # the last to have been heard of
        return seat

    def close(self) -> None:
        """Clear all tables once what is going on at them has ended."""
        with self._lock:
            for seat in self._seats.values():
                seat.close()
            self._seats.clear()
        self._clearing.shutdown()

    def _new(self, name: str, *, practice: bool) -> HumanSession:
        if practice and self._practice:
            store = PracticeStore(name, self._practice)
            return HumanSession(store, self._furnish, practice=True)
        return HumanSession(SessionStore(name, self._suite, self._out), self._furnish)

    def _give_up(self, key: tuple[str, bool]) -> None:
        """Clear a seat, unless something goes on there; then it stays until there is need of it."""
        seat = self._seats.get(key)
        if seat is not None and seat.state.doing is None:
            self._clearing.submit(self._seats.pop(key).close)

    def _make_room(self) -> None:
        if len(self._seats) < self._number:
            return
        idle = [key for key, seat in self._seats.items() if seat.state.doing is None]
        if not idle:
            raise NotNow("All seats are taken at the moment. Try again in a minute.")
        self._clearing.submit(self._seats.pop(idle[0]).close)


def _is_through(seat: HumanSession) -> bool:
    state = seat.state
    return state.doing is None and state.over and state.done == state.total
