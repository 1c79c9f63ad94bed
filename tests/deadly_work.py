"""Work that kills whoever does it, or ends it; worker processes have to be able to import it."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import NoReturn

from probe.assets.library import Library
from probe.errors import ProbeError
from probe.generation.making import TaskMaker
from probe.render.renderer import Renderer
from probe.runs.plan import Job
from probe.runs.work import WorkerSetup
from probe.tasks.task import Task


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


def refuse(task: Task, library: Library, renderer: Renderer) -> NoReturn:
    """Ends a build over the check of a task, to show that it was asked."""
    raise ProbeError(f"{task.id} was measured again")
