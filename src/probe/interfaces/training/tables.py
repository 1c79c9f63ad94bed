"""Tables for training by reward: who may sit down, which run it is, where its record goes."""

from __future__ import annotations

from collections import Counter
from contextlib import ExitStack
from pathlib import Path
from threading import Lock, Thread, main_thread
from typing import Any

from anyio.from_thread import BlockingPortal, start_blocking_portal

from probe.bench.process_pool import EpisodeProcessPool
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, add_line, occupied, start_folder
from probe.episodes.grading import question_of
from probe.errors import BadData, ProbeError, UnknownName
from probe.interfaces.training.permission import check_for_training
from probe.interfaces.training.seat import Seat
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.plan import Job, RunOrder
from probe.runs.run import check_settings
from probe.tasks.suite import Suite
from probe.tasks.task import Task
from probe.transcripts.messages import opening
from probe.transcripts.prompts import Graphs, graphs_of
from probe.transcripts.tools import as_sent
from probe.types import USUAL_SCALE

MOST = 64
"""Tables at once, if nobody says how many."""


class TooFewTables(ProbeError):
    """More episodes are under way than there may be tables."""

    def __init__(self, most: int) -> None:
        super().__init__(
            f"{most} episodes are under way, and there are no more tables. Allow as many as "
            "rollouts are under way at once, or fewer rollouts."
        )


class TrainingTables:
    """Tables for training by reward, each in a process of its own.

    Make them with `probe.training_tables`. Processes start when they are first needed and serve one
    episode after another. Close them at the end, or use them in a `with` block.

    Args:
        suite: What is asked.
        setup: What each process is told; its order says who acts, how lists are told in the setting
            "text-only", and how tools err.
        most: Episodes at once; also an attribute.
        out: Folder for the records; None to keep none.
        evaluation: Take tasks of evaluation, too, to measure and not to train.

    Raises:
        NotForTraining: The suite has a task that models are evaluated on.
        BadData: A task is for another set-up, the folder is about another suite, or another run is
            at work there.
    """

    def __init__(
        self,
        suite: Suite,
        setup: EpisodeWorkerSetup,
        *,
        most: int = MOST,
        out: Path | None = None,
        evaluation: bool = False,
    ) -> None:
        if not evaluation:
            check_for_training(suite)
        _check_scale(suite)
        self.most = most
        self._tasks = {task.id: task for task in suite}
        self._setup = setup
        self._out = out
        self._lock, self._held = Lock(), ExitStack()
        self._portal: BlockingPortal | None = None
        self._pool = EpisodeProcessPool(setup, most)
        self._seats = set[Seat]()
        self._runs = Counter[str]()
        if out is not None:
            self._take_up(out, suite)

    def __enter__(self) -> TrainingTables:
        """These."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close them."""
        self.close()

    @property
    def order(self) -> RunOrder:
        """Who acts, and under which conditions."""
        return self._setup.order

    @property
    def graphs(self) -> Graphs:
        """How lists of objects are told."""
        return graphs_of(self.order.setting)

    def rows(self) -> list[dict[str, Any]]:
        """A row of a trainer's data set for each task: `prompt`, its first messages, and `task`."""
        return [self.row(id) for id in self._tasks]

    def row(self, task: str) -> dict[str, Any]:
        """A row for one task, by its id.

        Raises:
            UnknownName: There is no such task.
        """
        asked = self._task(task)
        first = opening("text-only", self.order.points, question_of(asked), (), asked.scale)
        return {"prompt": [{"role": it.role, "content": it.text} for it in first], "task": task}

    @property
    def tools(self) -> list[dict[str, Any]]:
        """The five tools, as servers that speak OpenAI's protocol get them."""
        return as_sent(self.order.points, USUAL_SCALE, "text-only")

    def seat(self, task: str) -> Seat:
        """A seat at a fresh table; it is being set when this returns.

        Args:
            task: Id of the task; each time that it is played is another run.

        Raises:
            UnknownName: There is no such task.
            TooFewTables: All tables are taken.
        """
        asked = self._task(task)
        with self._lock:
            if len(self._seats) >= self.most:
                raise TooFewTables(self.most)
            job = Job(asked, self._runs[task])
            self._runs[task] += 1
            seat = Seat(self._portal or self._opened(), self._pool, job)
            self._seats.add(seat)
            return seat

    def give_back(self, seat: Seat, line: bytes | None = None) -> None:
        """Give a seat to others, and keep a record of what was played, as it is written down."""
        seat.leave()
        with self._lock:
            self._seats.discard(seat)
            if line is not None and self._out is not None:
                add_line(self._out, line)

    def close(self) -> None:
        """End all processes; what is under way is lost."""
        for seat in tuple(self._seats):
            self.give_back(seat)
        with self._lock:
            self._pool.close()
            self._held.close()
            self._portal = None

    def _task(self, id: str) -> Task:
        if id not in self._tasks:
            raise UnknownName("task", id, list(self._tasks))
        return self._tasks[id]

    def _opened(self) -> BlockingPortal:
        """Start the event loop."""
        self._portal = self._held.enter_context(start_blocking_portal())
        # Its threads wait for processes, and Python for these threads, before it calls atexit.
        Thread(target=self._close_with_program, daemon=True).start()
        return self._portal

    def _close_with_program(self) -> None:
        main_thread().join()
        self.close()

    def _take_up(self, out: Path, suite: Suite) -> None:
        start_folder(out, suite)
        self._held.enter_context(occupied(out, suite))
        if (out / RECORDS).exists():
            earlier = read_records(out / RECORDS)
            check_settings(out / RECORDS, earlier, self.order)
            for record in earlier:
                self._runs[record.task] = max(self._runs[record.task], record.run + 1)


def _check_scale(suite: Suite) -> None:
    """See that the tools' texts, which stand in docstrings, are true of all tasks."""
    for task in suite.tasks:
        if task.scale != USUAL_SCALE:
            reason = f"{task.id} is for a set-up whose pictures show another part of the table"
            raise BadData(suite.name, reason, "Train on tasks of the usual table")
