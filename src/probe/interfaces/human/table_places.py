"""Where a seat's tables are set: the next one stands ready while a person is at the one before."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass

from probe.episodes.episode import Episode
from probe.episodes.record import EpisodeRecord
from probe.interfaces.human.feedback import Feedback
from probe.tasks.task import Task


@dataclass(frozen=True)
class TablePlace:
    """Where one table at a time can stand.

    Attributes:
        set_table: A fresh episode with pictures, of a task, for a person's run of that number;
            clears the table before it.
        explain: What was right and why, once the episode of the table that stands here has ended.
    """

    set_table: Callable[[Task, str, int], Episode]
    explain: Callable[[Task, EpisodeRecord], Feedback]


Furnish = Callable[[], AbstractContextManager[TablePlace]]
"""Opens what a place needs for as long as its seat is taken: something to draw with, say."""

_Set = tuple[TablePlace, Episode]


class TablesAhead:
    """Two places for tables, used in turn; all tables are set in one thread of their own.

    Args:
        furnish: Opens a place; the second is opened when a table is first prepared.
        name: Of the person.
    """

    def __init__(self, furnish: Furnish, name: str) -> None:
        self._furnish = furnish
        self._name = name
        self._thread = ThreadPoolExecutor(1, "tables")
        self._stack = ExitStack()
        self._places: list[TablePlace] = []
        self._current: TablePlace | None = None
        self._ready: tuple[str, int, Future[_Set]] | None = None

    def prepare(self, task: Task, run: int) -> None:
        """Begin to set the table of the task that comes next; returns at once."""
        self._ready = task.id, run, self._thread.submit(self._set, task, run)

    def take(self, task: Task, run: int) -> Episode:
        """The table of a task, prepared or set now; the one before is cleared.

        Raises:
            ProbeError: It can't be set; the next call tries again.
        """
        ready, self._ready = self._ready, None
        if ready is not None and ready[:2] == (task.id, run):
            future = ready[2]
        else:
            future = self._thread.submit(self._set, task, run)
        self._current, episode = future.result()
        # Whoever is asked sees the question only now.
        episode.restart_clock()
        return episode

    def explain(self, task: Task, record: EpisodeRecord) -> Feedback:
        """What was right in the episode that has ended at the table that was taken last."""
        assert self._current is not None, "no table has been taken"
        return self._current.explain(task, record)

    def close(self) -> None:
        """Clear the tables once what is being set stands."""
        self._thread.shutdown(cancel_futures=True)
        self._stack.close()

    def _set(self, task: Task, run: int) -> _Set:
        free = next((place for place in self._places if place is not self._current), None)
        if free is None:
            free = self._stack.enter_context(self._furnish())
            self._places.append(free)
        return free, free.set_table(task, self._name, run)
