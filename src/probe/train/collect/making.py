"""Training tasks, place by place, in worker processes: by the generator alone, with no solver."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from probe.assets.library import Library
from probe.assets.pools.split import part_of, read_split
from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.errors import Unsatisfiable
from probe.generation.build import BuildResources, fill
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.render.renderer import Renderer

FIRST_EPISODE = 2_000_000
"""Training seeds start at 2,000,000,000: no suite's episode comes that far."""


@dataclass(frozen=True)
class Training:
    """Opens the objects for training: of a split its training part; a value for workers.

    Attributes:
        opened: Opens the whole library.
        split: File of a split; None to take all.
    """

    opened: Callable[[], Library]
    split: Path | None = None

    def __call__(self) -> Library:
        """The objects.

        Raises:
            BadData: The split can't be read.
        """
        things = self.opened()
        return things if self.split is None else part_of(things, read_split(self.split), "train")


@dataclass(frozen=True)
class TaskWorker:
    """A worker that makes tasks; see probe.processes.serving.Opening.

    Attributes:
        parts: Where tasks and logs go.
        library: Opens the objects.
        tables: Ids of table materials.
    """

    parts: BuildFolder
    library: Callable[[], Library]
    tables: Sequence[str]

    @contextmanager
    def __call__(self) -> Generator[Callable[[TaskSlot], bytes]]:
        """Open the library and start a renderer; gives what makes a task."""
        things = self.library()
        with Renderer(things.light_cache) as renderer:
            resources = BuildResources(things, self.tables, renderer, unchecked=True)
            yield partial(_made, self.parts, resources)


def make_tasks(
    worker: TaskWorker, places: Sequence[TaskSlot], engine: Engine
) -> Generator[tuple[TaskSlot, str | None]]:
    """Make the tasks that aren't there yet; yields each place with what went wrong, if it did.

    Raises:
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers die before they begin.
    """
    waiting = list[TaskSlot]()
    for place in places:
        if worker.parts.task_path(place).exists():
            yield place, None
        else:
            waiting.append(place)
    plan = WorkPlan("tasks", worker, waiting, lambda it: f"{it.question_type}-{it.episode}")
    results = engine.carry_out(plan)
    try:
        for place, result in results:
            if isinstance(result, LostUnit):
                yield place, result.reason
            else:
                yield place, result.decode() or None
    finally:
        results.close()


def _made(parts: BuildFolder, resources: BuildResources, place: TaskSlot) -> bytes:
    try:
        for _ in fill(place, parts, resources):
            pass
    except Unsatisfiable as error:
        return str(error).encode()
    return b""
