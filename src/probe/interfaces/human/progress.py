"""Which questions of a suite a person is through with. Knows no table and no page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task

FAULTS = 3
"""So many failures of ours on one question, and the person is spared it."""


class HumanProgress:
    """What one person has done, and what comes next.

    Args:
        tasks: Of the suite, in its order.
        records: The person's, from earlier sittings.
    """

    def __init__(self, tasks: Sequence[Task], records: Iterable[EpisodeRecord]) -> None:
        self._tasks = tuple(tasks)
        self._faults: Counter[str] = Counter()
        self._ended: Counter[str] = Counter()
        for record in records:
            self.add(record)

    def add(self, record: EpisodeRecord) -> None:
        """A record has been written."""
        (self._faults if record.end == "fault" else self._ended)[record.task] += 1

    @property
    def total(self) -> int:
        """Questions of the suite."""
        return len(self._tasks)

    @property
    def done(self) -> int:
        """How many questions the person is through with."""
        return sum(self._is_done(task) for task in self._tasks)

    def run_of(self, task: Task) -> int:
        """Number of the run that comes next; one that failed on our side is done again."""
        return self._ended[task.id]

    def next(self, after: Task | None = None) -> tuple[int, Task] | None:
        """Place in the suite, from 0, and task of the first question that is still open.

        Args:
            after: The question that a person is at, which is open as well; None for no such.
        """
        open_ones = (it for it in enumerate(self._tasks) if not self._is_done(it[1]))
        return next((it for it in open_ones if it[1] is not after), None)

    def _is_done(self, task: Task) -> bool:
        return self._ended[task.id] > 0 or self._faults[task.id] >= FAULTS
