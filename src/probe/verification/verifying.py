"""Checks many tasks, by any engine: each task is a unit of work."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

from probe.assets.cache import content_key
from probe.assets.library import Library
from probe.engines.plan import WorkPlan
from probe.generation.attempt import Attempt
from probe.render.renderers import Renderers
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash
from probe.tasks.task import Task
from probe.verification.check import CheckDepth, check, rebuild_problem


@dataclass(frozen=True)
class SuiteVerifier:
    """What checks tasks; see probe.processes.serving.Opening. A result is a verdict as JSON.

    Attributes:
        library: Opens the objects.
        solve: Whether scripted agents have to solve each task again.
        played: Ids of tasks on which random histories are played.
    """

    library: Callable[[], Library]
    solve: bool
    played: frozenset[str]

    def depth(self, task: Task) -> CheckDepth:
        """Which checks of a task are made."""
        return CheckDepth(solve=self.solve, history=task.id in self.played)

    @contextmanager
    def __call__(self) -> Generator[Callable[[Task], bytes]]:
        """Open the library and start renderers; gives what checks a task."""
        things = self.library()
        with Renderers(things.light_cache) as renderers:
            yield partial(self._checked, things, renderers)

    def _checked(self, things: Library, renderers: Renderers, task: Task) -> bytes:
        renderer = renderers[task.setup.renderer]
        return check(task, things, renderer, self.depth(task)).model_dump_json().encode()

    def plan(self, suite: Suite, tasks: Sequence[Task]) -> WorkPlan[Task]:
        """The work of checking some tasks of a suite; of other depth it has another name."""
        key = content_key(content_hash(suite), str(self.solve), *sorted(self.played))
        return WorkPlan(f"verify-{key}", self, tasks, lambda task: task.id)


@dataclass(frozen=True)
class Rebuilder:
    """What makes tasks from their seeds again. A result says what is different; empty if nothing.

    Attributes:
        library: Opens the objects that they were made of.
        pool: What that is called.
        tables: Ids of table materials that they were made with.
        known: The attempts that made them, by id; of others the seed tells.
    """

    library: Callable[[], Library]
    pool: str
    tables: Sequence[str]
    known: Mapping[str, Attempt]

    @contextmanager
    def __call__(self) -> Generator[Callable[[Task], bytes]]:
        """Open the library and start renderers; gives what makes a task again."""
        things = self.library()
        with Renderers(things.light_cache) as renderers:
            yield partial(self._problem, things, renderers)

    def _problem(self, things: Library, renderers: Renderers, task: Task) -> bytes:
        made_by, renderer = self.known.get(task.id), renderers[task.setup.renderer]
        problem = rebuild_problem(task, things, renderer, self.tables, made_by)
        return (problem or "").encode()

    def plan(self, suite: Suite, tasks: Sequence[Task]) -> WorkPlan[Task]:
        """The work of making some tasks of a suite again; in another way it has another name."""
        way = (self.pool, repr(sorted(self.known.items())), *self.tables)
        key = content_key(content_hash(suite), *way)
        return WorkPlan(f"rebuild-{key}", self, tasks, lambda task: task.id)
