"""Tables for samples that run at once: each has a process, and one that dies is replaced."""

from __future__ import annotations

from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager

from anyio import CapacityLimiter, Semaphore

from probe.bench.process import SILENCE, AskPointer, EpisodeProcess, EpisodeProcessDied
from probe.engines.plan import TRIES
from probe.episodes.turns import Call
from probe.errors import ProbeError, WorkerDied
from probe.processes.serving import WorkerUnfit
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.plan import Job
from probe.runs.worker_messages import (
    CallResult,
    EpisodeFailed,
    EpisodeFinished,
    EpisodeStarted,
    FinishEpisode,
    GradeRecord,
    Request,
    Response,
    StartEpisode,
)


class EpisodeProcessLost(ProbeError):
    """A table failed as often as it may be set again; the message is the last reason."""


class EpisodeProcessPool:
    """A number of processes; who finds none free waits.

    Args:
        place: What each is told.
        count: How many.
        pointing: Whether perception asks a model.
        silence: Seconds without a word after which a process is taken to hang.
    """

    def __init__(
        self,
        place: EpisodeWorkerSetup,
        count: int,
        *,
        pointing: bool = False,
        silence: float = SILENCE,
    ) -> None:
        self._place = place
        self._pointing = pointing
        self._silence = silence
        self._stillborn = 0
        self._slots = Semaphore(count)
        self._limiter = CapacityLimiter(count)
        self._free: list[EpisodeProcess] = []

    @asynccontextmanager
    async def seat(self, ask: AskPointer) -> AsyncGenerator[Assignment]:
        """A seat at a table that nobody else uses, until the block ends."""
        async with self._slots:
            assignment = Assignment(self, ask)
            try:
                yield assignment
            except BaseException:
                assignment.get_up(break_off=True)
                raise
            assignment.get_up()

    async def take(self) -> EpisodeProcess:
        """A process that is free, or a new one.

        Raises:
            WorkerUnfit: None can be set up.
            TableDied: It died before it could work.
            WorkerDied: So did those before it.
        """
        if self._free:
            return self._free.pop()
        made = EpisodeProcess(
            self._place, pointing=self._pointing, limiter=self._limiter, silence=self._silence
        )
        try:
            await made.ready()
        except EpisodeProcessDied as error:
            made.kill()
            self._stillborn += 1
            if self._stillborn >= TRIES:
                raise WorkerDied("setting up") from error
            raise
        except BaseException:
            made.kill()
            raise
        self._stillborn = 0
        return made

    def give_back(self, process: EpisodeProcess) -> None:
        """Somebody else may have it."""
        self._free.append(process)

    def close(self) -> None:
        """End the processes that nobody uses."""
        while self._free:
            self._free.pop().kill()


class Assignment:
    """One episode at a table that may fail under it.

    A new table then takes its place, on which everything that was done is done again: the same
    luck gives the same table, so that the model is asked nothing twice. A table that can't be set
    up at all is no such failure: the next one couldn't either.
    """

    def __init__(self, pool: EpisodeProcessPool, ask: AskPointer) -> None:
        self._pool = pool
        self._ask = ask
        self._process: EpisodeProcess | None = None
        self._done: list[Request] = []
        self._failures: list[str] = []

    @property
    def failures(self) -> tuple[str, ...]:
        """Why tables had to be set again."""
        return tuple(self._failures)

    async def sit(self, job: Job) -> EpisodeStarted:
        """Have the table set; see Sit. All of these raise TableLost, WorkerUnfit, WorkerDied."""
        response = await self._do(StartEpisode(job))
        assert isinstance(response, EpisodeStarted)
        return response

    async def call(self, call: Call) -> CallResult:
        """Call a tool."""
        response = await self._do(call)
        assert isinstance(response, CallResult)
        return response

    async def leave(self, leave: FinishEpisode) -> EpisodeFinished:
        """Hand in the record."""
        return await self._left(leave)

    async def grade(self, grade: GradeRecord) -> EpisodeFinished:
        """Grade a record that was made before."""
        return await self._left(grade)

    def get_up(self, *, break_off: bool = False) -> None:
        """Give the table back; one that is left in the middle of something is ended."""
        if self._process is not None:
            if break_off:
                self._process.kill()
            else:
                self._pool.give_back(self._process)
            self._process = None

    async def _left(self, request: FinishEpisode | GradeRecord) -> EpisodeFinished:
        response = await self._do(request)
        assert isinstance(response, EpisodeFinished)
        return response

    async def _do(self, request: Request) -> Response:
        lacking = [request] if self._process is not None else [*self._done, request]
        try:
            while isinstance(response := await self._try(lacking), EpisodeFailed):
                self.get_up(break_off=True)
                self._failures.append(response.reason)
                if len(self._failures) >= TRIES:
                    raise EpisodeProcessLost(f"{response.reason} ({TRIES} times in all)")
                lacking = [*self._done, request]
        except BaseException:
            # The table may still wait for what its perception asked; this request never was.
            self.get_up(break_off=True)
            raise
        self._done.append(request)
        return response

    async def _try(self, requests: list[Request]) -> Response:
        """Do requests one after another; the last one's response, or the first that is broken."""
        response: Response = EpisodeFailed("nothing was asked for")
        try:
            if self._process is None:
                self._process = await self._pool.take()
            for request in requests:
                response = await self._process.request(request, self._ask)
                if isinstance(response, EpisodeFailed):
                    return response
        except (WorkerUnfit, WorkerDied):
            raise
        except ProbeError as error:
            return EpisodeFailed(str(error))
        return response
