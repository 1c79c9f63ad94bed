"""Worker processes that do jobs one at a time; the death of one costs one job. Knows no episodes.

Each has a pipe of its own and shares no lock with the others, so that one that is killed at any
moment, even while it sends, takes nobody with it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Generator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import wait
from typing import Generic, TypeVar, cast

from probe.errors import WorkerDied
from probe.processes.serving import Opening, WorkerReady
from probe.processes.starting import spawn
from probe.processes.worker_process import WorkerProcess, WorkerSilent

Job = TypeVar("Job")

TRIES = 3
"""How often a job is begun when workers die over it."""

_PATIENCE = 20.0
"""Seconds that a worker without jobs may take to close its renderer."""


@dataclass(frozen=True)
class LostJob:
    """What is left of a job over which every worker died.

    Attributes:
        reason: In words.
    """

    reason: str


@dataclass(eq=False)
class _Worker(Generic[Job]):
    """A worker process, the job that it is at and how often that was begun."""

    process: WorkerProcess
    job: Job | None = None
    tries: int = 0


def carry_out(
    opening: Opening[Job, bytes], jobs: Sequence[Job], workers: int
) -> Generator[tuple[Job, bytes | LostJob]]:
    """Do jobs in worker processes; yields each with what came of it, as it is known.

    Close the iterator to end the workers at once.

    Raises:
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers keep dying before they get anything to do.
    """
    crew = _Crew[Job](opening, deque((job, 1) for job in jobs))
    try:
        for _ in range(min(workers, len(jobs))):
            crew.hire()
        while crew.workers:
            for worker in crew.speaking():
                found = crew.hear(worker)
                if found is not None:
                    yield found
    finally:
        crew.dismiss()


class _Crew(Generic[Job]):
    def __init__(self, opening: Opening[Job, bytes], waiting: deque[tuple[Job, int]]) -> None:
        self.workers: list[_Worker[Job]] = []
        self._opening = opening
        self._waiting = waiting
        self._stillborn = 0

    def hire(self) -> None:
        """Start one more worker."""
        self.workers.append(_Worker(spawn(self._opening)))

    def speaking(self) -> list[_Worker[Job]]:
        """Workers that have said something, or died; waits until there is one."""
        said = wait([worker.process.pipe for worker in self.workers])
        return [worker for worker in self.workers if worker.process.pipe in said]

    def hear(self, worker: _Worker[Job]) -> tuple[Job, bytes | LostJob] | None:
        """Take in what one has to say and give it the next job; a job and its result, if any."""
        try:
            message = worker.process.receive()
        except WorkerSilent as death:
            return self._bury(worker, death)
        if isinstance(message, WorkerReady):
            message.require()
        self._stillborn = 0
        job, worker.job = worker.job, None
        self._occupy(worker)
        return None if job is None else (job, cast(bytes, message))

    def dismiss(self) -> None:
        """End all workers, whatever they are at."""
        for worker in self.workers:
            worker.process.kill()
        self.workers.clear()

    def _occupy(self, worker: _Worker[Job]) -> None:
        """Give a worker the next job, or let it go home."""
        if self._waiting:
            worker.job, worker.tries = self._waiting.popleft()
            # One that is dead by now is noticed when nothing comes back.
            with suppress(WorkerSilent):
                worker.process.send(worker.job)
        else:
            self._part_with(worker)

    def _bury(self, worker: _Worker[Job], death: WorkerSilent) -> tuple[Job, LostJob] | None:
        """Replace a dead worker; its job is begun again, or lost."""
        self._part_with(worker)
        job = worker.job
        if job is None:
            self._stillborn += 1
            if self._stillborn >= TRIES:
                raise WorkerDied("setting up")
        elif worker.tries < TRIES:
            self._waiting.appendleft((job, worker.tries + 1))
        if self._waiting:
            self.hire()
        if job is None or worker.tries < TRIES:
            return None
        return job, LostJob(f"A worker process {death} at it, {TRIES} times in all")

    def _part_with(self, worker: _Worker[Job]) -> None:
        self.workers.remove(worker)
        worker.process.end(_PATIENCE)
