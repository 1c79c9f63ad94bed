"""One person's place: question after question, each at a table that one thread alone moves.

Knows no protocol.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

from probe.episodes.replay import NotAsBefore
from probe.episodes.turns import Call
from probe.errors import ProbeError
from probe.interfaces.human.live_episode import LiveEpisode
from probe.interfaces.human.session_store import Store
from probe.interfaces.human.state import State, at_table, between
from probe.interfaces.human.table_places import Furnish, TablesAhead
from probe.interfaces.human.words import (
    EXPLAINING,
    NOT_AS_BEFORE,
    NotNow,
    doing_words,
    trouble_words,
)
from probe.tasks.task import Task

_log = logging.getLogger(__name__)


class HumanSession:
    """A person's place; whatever touches the table happens in its thread, one thing at a time.

    What is shown is a value that is replaced whole, so that it may be read at any time.

    Args:
        store: Who sits there, and what they have done before.
        furnish: Opens what tables need.
        practice: Whether the person is told after each question what was right, and why.
    """

    def __init__(self, store: Store, furnish: Furnish, *, practice: bool = False) -> None:
        self._store = store
        self._tables = TablesAhead(furnish, store.name)
        self._thread = ThreadPoolExecutor(1, "seat")
        self._lock = threading.Lock()
        self._practice = practice
        self._state = between(State(practice=practice), store.progress)
        self._table: LiveEpisode | None = None

    @property
    def state(self) -> State:
        """What the person's page shows now."""
        return self._state

    def picture(self, number: int) -> bytes | None:
        """A picture of this question as PNG; None if there is none of that number."""
        pictures = self._table.pictures if self._table else ()
        return pictures[number] if 0 <= number < len(pictures) else None

    def evidence(self, number: int) -> bytes | None:
        """A picture of what was right, as PNG; None if there is none of that number."""
        feedback = self._state.feedback
        pictures = feedback.pictures if feedback else ()
        return pictures[number] if 0 <= number < len(pictures) else None

    def go_on(self) -> None:
        """Set the table of the first open question, unless one is set already.

        Raises:
            NotNow: Something is going on.
        """
        with self._lock:
            if self._state.over:
                self._start("Setting the table", self._advance)

    def call(self, call: Call, turn: int) -> None:
        """Have a call done; what comes of it will be in the state.

        Args:
            call: Of a tool.
            turn: How many calls the person has seen the outcome of.

        Raises:
            NotNow: Something is going on, or has happened that the person hasn't seen.
        """
        with self._lock:
            self._check(turn)
            self._start(doing_words(call.name), lambda: self._step(call))

    def stop(self, turn: int) -> None:
        """End this question without an answer; see call()."""
        with self._lock:
            self._check(turn)
            self._start("Writing it down", self._stop)

    def remark(self, number: int, *, ambiguous: bool, note: str) -> None:
        """Keep what the person says of the question of that number.

        Raises:
            NotNow: It isn't the question before them.
            OutputFailed: It can't be written.
        """
        with self._lock:
            if self._table is None or number != self._state.number:
                raise NotNow("That question isn't before you any more.")
            self._store.remark(self._table.task, ambiguous=ambiguous, note=note)
            self._state = replace(self._state, ambiguous=ambiguous, note=note)

    def close(self) -> None:
        """Clear the table once what is going on has ended; the person may come back to it."""
        self._thread.shutdown(cancel_futures=True)
        self._tables.close()

    def _check(self, turn: int) -> None:
        if self._state.doing is None and self._state.over:
            raise NotNow("This question is closed. Go on to the next one.")
        if turn != len(self._state.entries):
            raise NotNow("The page was behind. Look at what has happened, then go on.")

    def _start(self, doing: str, work: Callable[[], None]) -> None:
        """Let the thread do something; whoever calls holds the lock."""
        if self._state.doing is not None:
            raise NotNow("Something is still going on at your table. Wait until it has ended.")
        self._state = replace(self._state, doing=doing, trouble=None)
        self._thread.submit(self._guarded, work)

    def _guarded(self, work: Callable[[], None]) -> None:
        """Do something in the thread; what goes wrong on our side is told in words."""
        trouble = None
        try:
            work()
        except NotAsBefore as error:
            _log.error("%s", error)
            trouble = NOT_AS_BEFORE
        except Exception as error:  # the person is told that it was us, the log what it was
            _log.error("%s", error, exc_info=not isinstance(error, ProbeError))
            trouble = trouble_words(error)
        with self._lock:
            self._state = replace(self._state, doing=None, trouble=trouble)

    def _advance(self) -> None:
        self._store.write()
        found = self._store.progress.next()
        self._table = None
        with self._lock:
            self._state = between(self._state, self._store.progress)
        if found is not None:
            self._table = self._laid(*found)
            self._show(self._table)
            self._prepare(self._table.task)

    def _laid(self, place: int, task: Task) -> LiveEpisode:
        """A table as at the start, or as the person left it."""
        earlier, run = self._store.earlier(task)
        episode = self._tables.take(task, run)
        try:
            return LiveEpisode(place, task, episode, earlier)
        except NotAsBefore as error:
            assert earlier is not None
            self._store.end(replace(earlier, end="fault", fault=str(error)))
            raise

    def _prepare(self, task: Task) -> None:
        """Begin with the table of the question after this one, while the person is at it."""
        found = self._store.progress.next(after=task)
        if found is not None:
            self._tables.prepare(found[1], self._store.progress.run_of(found[1]))

    def _show(self, table: LiveEpisode) -> None:
        said = self._store.remarks.get(table.task.id)
        with self._lock:
            self._state = at_table(self._state, table.place, table.task, said)
        self._update(table)

    def _update(self, table: LiveEpisode) -> None:
        record = table.episode.record
        with self._lock:
            self._state = replace(
                self._state,
                entries=table.entries,
                manipulations=record.manipulations,
                pictures=len(table.pictures),
                over=table.episode.ended,
                done=self._store.progress.done,
            )

    def _step(self, call: Call) -> None:
        assert self._table is not None
        self._table.step(call)
        record = self._table.episode.record
        try:
            if self._table.episode.ended:
                self._store.end(record)
            else:
                self._store.keep(record)
        finally:
            self._update(self._table)
        self._explain(self._table)

    def _stop(self) -> None:
        assert self._table is not None
        try:
            self._store.end(self._table.episode.record)
        finally:
            with self._lock:
                done = self._store.progress.done
                self._state = replace(self._state, over=True, stopped=True, done=done)
        self._explain(self._table)

    def _explain(self, table: LiveEpisode) -> None:
        """Say what was right, in practice alone, once a question is over by the person's doing."""
        record = table.episode.record
        if not self._practice or not self._state.over or record.end == "fault":
            return
        with self._lock:
            self._state = replace(self._state, doing=EXPLAINING)
        feedback = self._tables.explain(table.task, record)
        with self._lock:
            self._state = replace(self._state, feedback=feedback)
