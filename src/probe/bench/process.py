"""A worker process with a table, asked without ever keeping the event loop waiting."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from dataclasses import replace
from multiprocessing import get_context
from multiprocessing.connection import wait
from multiprocessing.process import BaseProcess
from typing import cast

from anyio import CapacityLimiter
from anyio.to_thread import run_sync

from probe.errors import ProbeError
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.worker import WorkerReady, serve
from probe.runs.worker_messages import NoReply, PointerRequest, Request, Response
from probe.runs.worker_pool import WorkerUnfit, death

AskPointer = Callable[[PointerRequest], Awaitable[str | NoReply]]
"""Asks the model that points."""

_SPAWN = get_context("spawn")


SILENCE = 1800.0
"""Seconds without a word from a process after which it is taken to hang; a request takes seconds,
and setting up for the first time minutes."""


class EpisodeProcessDied(ProbeError):
    """A process with a table has died, or hangs; the message says how."""


class EpisodeProcess:
    """One process; whoever has it is alone with it.

    Args:
        place: What it is told; the way to a model that points is laid here if one is wanted.
        pointing: Whether perception asks a model.
        limiter: Of threads that wait for processes.
        silence: Seconds without a word after which it is taken to hang.
    """

    def __init__(
        self,
        place: EpisodeWorkerSetup,
        *,
        pointing: bool,
        limiter: CapacityLimiter,
        silence: float = SILENCE,
    ) -> None:
        self._limiter = limiter
        self._silence = silence
        self._pipe, theirs = _SPAWN.Pipe()
        self._asking, asking = _SPAWN.Pipe()
        told = replace(place, asking=asking) if pointing else place
        self._pipes = [self._pipe, self._asking] if pointing else [self._pipe]
        self._process: BaseProcess = _SPAWN.Process(target=serve, args=(told, theirs), daemon=True)
        self._process.start()
        theirs.close()
        asking.close()

    async def ready(self) -> None:
        """Wait until it can work.

        Raises:
            WorkerUnfit: It can't.
            TableDied: It died before it could, or hangs.
        """
        first = cast("WorkerReady", await self._heard())
        if first.problem:
            raise WorkerUnfit(first.problem)

    async def request(self, request: Request, ask: AskPointer) -> Response:
        """Have a request done; what perception asks meanwhile is passed on.

        Raises:
            TableDied: It won't come back.
        """
        try:
            self._pipe.send(request)
        except OSError as error:
            raise EpisodeProcessDied(self._how()) from error
        while isinstance(heard := await self._heard(), PointerRequest):
            reply = await ask(heard)
            try:
                self._asking.send(reply)
            except OSError as error:
                raise EpisodeProcessDied(self._how()) from error
        return cast("Response", heard)

    def kill(self) -> None:
        """End it at once, whatever it is at."""
        self._process.kill()
        self._process.join()
        self._pipe.close()
        self._asking.close()

    @property
    def pid(self) -> int | None:
        """Of the process."""
        return self._process.pid

    async def _heard(self) -> object:
        try:
            return await run_sync(self._hear, abandon_on_cancel=True, limiter=self._limiter)
        except (EOFError, OSError) as error:
            raise EpisodeProcessDied(self._how()) from error

    def _hear(self) -> object:
        said = wait(self._pipes, self._silence)
        if not said:
            raise EpisodeProcessDied(
                f"A worker process said nothing for {self._silence:.0f} seconds"
            )
        return (self._pipe if self._pipe in said else self._asking).recv()

    def _how(self) -> str:
        self._process.join(5.0)
        return f"A worker process {death(self._process.exitcode)}"
