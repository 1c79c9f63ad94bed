"""One episode at a table of its own, for callers that wait for each result. Knows no trainer."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from concurrent.futures import Future
from contextlib import AsyncExitStack
from typing import TypeVar

from anyio.from_thread import BlockingPortal

from probe.bench.process_pool import Assignment, EpisodeProcessPool
from probe.episodes.turns import Call
from probe.runs.plan import Job
from probe.runs.worker_messages import (
    CallResult,
    EpisodeFinished,
    FinishEpisode,
    NoReply,
    PointerRequest,
)

Asked = TypeVar("Asked")
Came = TypeVar("Came")


class Seat:
    """A table is set while the caller goes on; its first call waits for that.

    Each method may raise what Assignment's do. `leave` has to be called at the end.

    Args:
        portal: To the event loop in which processes are waited for.
        pool: Has the processes.
        job: What is played.
    """

    def __init__(self, portal: BlockingPortal, pool: EpisodeProcessPool, job: Job) -> None:
        self.job = job
        self._portal = portal
        self._pool = pool
        self._held = AsyncExitStack()
        self._begun: Future[Assignment] = portal.start_task_soon(self._begin)

    @property
    def failures(self) -> tuple[str, ...]:
        """Why tables had to be set again."""
        return self._begun.result().failures

    def call(self, call: Call) -> CallResult:
        """Call a tool."""
        return self._wait(self._begun.result().call, call)

    def finish(self, request: FinishEpisode) -> EpisodeFinished:
        """Hand in the record and have it graded."""
        return self._wait(self._begun.result().leave, request)

    def leave(self) -> None:
        """Give the table to others."""
        self._begun.exception()
        self._portal.call(self._held.aclose)

    def _wait(self, work: Callable[[Asked], Awaitable[Came]], asked: Asked) -> Came:
        """Have something done; an interrupted caller breaks it off, table and all.

        Otherwise its result would be taken for that of whatever is asked of the table next.
        """
        coming = self._portal.start_task_soon(work, asked)
        try:
            return coming.result()
        except BaseException:
            coming.cancel()
            raise

    async def _begin(self) -> Assignment:
        assignment = await self._held.enter_async_context(self._pool.seat(_nobody))
        await assignment.sit(self.job)
        return assignment


async def _nobody(asked: PointerRequest) -> NoReply:
    return NoReply("nobody points")
