"""A worker process with a table, asked without ever keeping the event loop waiting."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import replace
from multiprocessing import Pipe
from typing import cast

from anyio import CapacityLimiter
from anyio.to_thread import run_sync

from probe.errors import ProbeError
from probe.processes.serving import WorkerReady
from probe.processes.starting import spawn
from probe.processes.worker_process import WorkerSilent
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.worker_messages import NoReply, PointerRequest, Request, Response

AskPointer = Callable[[PointerRequest], Awaitable[str | NoReply]]
"""Asks the model that points."""

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
        self._asking, asking = Pipe()
        self._process = spawn(replace(place, asking=asking) if pointing else place)
        self._others = [self._asking] if pointing else []
        asking.close()

    async def ready(self) -> None:
        """Wait until it can work.

        Raises:
            WorkerUnfit: It can't.
            EpisodeProcessDied: It died before it could, or hangs.
        """
        cast("WorkerReady", await self._heard()).require()

    async def request(self, request: Request, ask: AskPointer) -> Response:
        """Have a request done; what perception asks meanwhile is passed on.

        Raises:
            EpisodeProcessDied: It won't come back.
        """
        with _told():
            self._process.send(request)
        while isinstance(heard := await self._heard(), PointerRequest):
            reply = await ask(heard)
            # One that is dead by now is noticed when nothing comes back.
            with suppress(OSError):
                self._asking.send(reply)
        return cast("Response", heard)

    def kill(self) -> None:
        """End it at once, whatever it is at."""
        self._process.kill()
        self._asking.close()

    async def _heard(self) -> object:
        with _told():
            return await run_sync(self._hear, abandon_on_cancel=True, limiter=self._limiter)

    def _hear(self) -> object:
        return self._process.receive(self._silence, *self._others)


@contextmanager
def _told() -> Generator[None]:
    try:
        yield
    except WorkerSilent as error:
        raise EpisodeProcessDied(f"A worker process {error}") from error
