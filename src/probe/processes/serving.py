"""What a worker process does until nobody asks any more. Knows no siblings and no episodes."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager, ExitStack, suppress
from dataclasses import dataclass
from multiprocessing import parent_process
from multiprocessing.connection import Connection, wait
from typing import TypeVar

from probe.errors import OutputFailed, ProbeError

Job = TypeVar("Job")
Result = TypeVar("Result")

Opening = Callable[[], AbstractContextManager[Callable[[Job], Result]]]
"""Sets a worker up and gives what does a job; it is sent to the worker, so it has to be of a
module or a value of such a class. The doing may raise OutputFailed if this machine's disk is full;
whatever else it raises is a fault of this program."""

_MEMORY = "Raise the limit (ulimit -v), leave other programs, or say --workers 1."


class WorkerUnfit(ProbeError):
    """A worker couldn't be set up; the message is the reason."""


@dataclass(frozen=True)
class WorkerReady:
    """A worker's first message, with the reason if it can't work, and its last if it can't go on.

    All others are results.
    """

    problem: str | None = None

    def require(self) -> None:
        """Go on if it can work.

        Raises:
            WorkerUnfit: It can't.
        """
        if self.problem:
            raise WorkerUnfit(self.problem)


def serve(opening: Opening[Job, Result], pipe: Connection) -> None:
    """Set up once, then do job after job; the function that a worker process runs.

    Args:
        opening: Sets it up.
        pipe: Jobs come from there and results go there, the first of them whether it can work.
    """
    # Ctrl-C reaches every process of a terminal; the parent alone decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    with ExitStack() as stack:
        try:
            carry = stack.enter_context(opening())
        except ProbeError as error:
            pipe.send(WorkerReady(str(error)))
            return
        except (MemoryError, ImportError) as error:
            # A library that can't be mapped into memory is said to be missing.
            pipe.send(WorkerReady(f"A worker process got no memory ({error}). {_MEMORY}"))
            return
        with suppress(EOFError, BrokenPipeError):
            pipe.send(WorkerReady())
            try:
                while True:
                    pipe.send(carry(pipe.recv()))
            except OutputFailed as error:
                # A full disk is no fault of the job: every other one would fail as well.
                pipe.send(WorkerReady(str(error)))


def _end_with_parent() -> None:
    """End this process when its parent is gone, even if that was killed."""
    parent = parent_process()
    assert parent is not None
    wait([parent.sentinel])
    os._exit(1)
