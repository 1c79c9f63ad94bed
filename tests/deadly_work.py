"""Work that kills whoever does it; worker processes have to be able to import it."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import NoReturn

from probe.generation.making import TaskMaker
from probe.runs.plan import Job
from probe.runs.work import WorkerSetup


@dataclass(frozen=True)
class Deadly(WorkerSetup):
    """A workplace where every episode kills the worker."""

    @contextmanager
    def __call__(self) -> Generator[Callable[[Job], bytes]]:
        yield lambda job: os.kill(os.getpid(), signal.SIGKILL) or b""


class DeadlyMaker(TaskMaker):
    """A workplace where every place of a suite kills the worker."""

    @contextmanager
    def __call__(self) -> Generator[Callable[[object], bytes]]:
        yield lambda place: os.kill(os.getpid(), signal.SIGKILL) or b""


def aborts(name: str, task: object, run: int, library: object, renderer: object) -> NoReturn:
    """An agent that takes its process along, as a library does that finds no memory."""
    os.abort()
