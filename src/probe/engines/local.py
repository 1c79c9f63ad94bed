"""Worker processes of this machine that do units one at a time; the death of one costs one unit.

Each has a pipe of its own and shares no lock with the others, so that one that is killed at any
moment, even while it sends, takes nobody with it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Generator
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import wait
from typing import Generic, cast

from probe.engines.plan import TRIES, LostUnit, Unit, WorkPlan
from probe.errors import WorkerDied
from probe.processes.serving import Opening, WorkerReady
from probe.processes.starting import spawn
from probe.processes.worker_process import WorkerProcess, WorkerSilent

_PATIENCE = 20.0
"""Seconds that a worker without units may take to close its renderer."""


@dataclass(eq=False)
class _Worker(Generic[Unit]):
    """A worker process, the unit that it is at and how often that was begun."""

    process: WorkerProcess
    unit: Unit | None = None
    tries: int = 0


@dataclass(frozen=True)
class LocalEngine:
    """Worker processes of this machine; see probe.engines.plan.Engine.

    Attributes:
        workers: How many at most.
    """

    workers: int = 1

    def carry_out(self, plan: WorkPlan[Unit]) -> Generator[tuple[Unit, bytes | LostUnit]]:
        """Do all units in worker processes; see Engine."""
        pool = _Pool[Unit](plan.opening, deque((unit, 1) for unit in plan.units))
        try:
            for _ in range(min(self.workers, len(plan.units))):
                pool.hire()
            while pool.workers:
                for worker in pool.speaking():
                    found = pool.hear(worker)
                    if found is not None:
                        yield found
        finally:
            pool.dismiss()


class _Pool(Generic[Unit]):
    def __init__(self, opening: Opening[Unit, bytes], waiting: deque[tuple[Unit, int]]) -> None:
        self.workers: list[_Worker[Unit]] = []
        self._opening = opening
        self._waiting = waiting
        self._stillborn = 0

    def hire(self) -> None:
        """Start one more worker."""
        self.workers.append(_Worker(spawn(self._opening)))

    def speaking(self) -> list[_Worker[Unit]]:
        """Workers that have said something, or died; waits until there is one."""
        said = wait([worker.process.pipe for worker in self.workers])
        return [worker for worker in self.workers if worker.process.pipe in said]

    def hear(self, worker: _Worker[Unit]) -> tuple[Unit, bytes | LostUnit] | None:
        """Take in what one has to say and give it the next unit; a unit and its result, if any."""
        try:
            message = worker.process.receive()
        except WorkerSilent as death:
            return self._bury(worker, death)
        if isinstance(message, WorkerReady):
            message.require()
        self._stillborn = 0
        unit, worker.unit = worker.unit, None
        self._occupy(worker)
        return None if unit is None else (unit, cast(bytes, message))

    def dismiss(self) -> None:
        """End all workers, whatever they are at."""
        for worker in self.workers:
            worker.process.kill()
        self.workers.clear()

    def _occupy(self, worker: _Worker[Unit]) -> None:
        """Give a worker the next unit, or let it go home."""
        if self._waiting:
            worker.unit, worker.tries = self._waiting.popleft()
            # One that is dead by now is noticed when nothing comes back.
            with suppress(WorkerSilent):
                worker.process.send(worker.unit)
        else:
            self._part_with(worker)

    def _bury(self, worker: _Worker[Unit], death: WorkerSilent) -> tuple[Unit, LostUnit] | None:
        """Replace a dead worker; its unit is begun again, or lost."""
        self._part_with(worker)
        unit = worker.unit
        if unit is None:
            self._stillborn += 1
            if self._stillborn >= TRIES:
                raise WorkerDied("setting up")
        elif worker.tries < TRIES:
            self._waiting.appendleft((unit, worker.tries + 1))
        if self._waiting:
            self.hire()
        if unit is None or worker.tries < TRIES:
            return None
        return unit, LostUnit(f"A worker process {death} at it, {TRIES} times in all")

    def _part_with(self, worker: _Worker[Unit]) -> None:
        self.workers.remove(worker)
        worker.process.end(_PATIENCE)
