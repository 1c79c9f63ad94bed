"""Begin a public suite's next version: tasks that the hand can do stay, the others are made anew.

`python scripts/remake_suite.py v1 outputs/v1.1.json`, then the command that it prints. Each task
whose things can be moved (see probe.generation.movable) is kept byte for byte. Of the others the
build goes on with the candidate after the one that was kept. Takes about 6 seconds a task and
core; goes on where it was stopped.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Sequence
from contextlib import closing, contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import Pool, library, opener
from probe.assets.library import Library
from probe.cli.screen import bar, say
from probe.engines.local import LocalEngine
from probe.engines.plan import LostUnit, WorkPlan
from probe.errors import BadData
from probe.generation.attempt import Attempt
from probe.generation.build import begin
from probe.generation.build_folder import IMMOVABLE, KEPT, BuildFolder, CandidateLog
from probe.generation.movable import immovable
from probe.generation.plan import ATTEMPTS
from probe.render.renderer import Renderer
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash, find_suite
from probe.tasks.task import Task

EARLIER = "of the version before"
"""Stands in a log for the check that an earlier candidate failed."""


class MovableChecker:
    """What checks tasks; a result says what can't be moved, or is empty."""

    def __init__(self, pool: Pool) -> None:
        self._library = opener(pool)

    @contextmanager
    def __call__(self) -> Generator[Callable[[Task], bytes]]:
        """Open the library and start a renderer; gives what checks a task."""
        things = self._library()
        with Renderer(things.light_cache) as renderer:
            yield partial(self._checked, things, renderer)

    def _checked(self, things: Library, renderer: Renderer, task: Task) -> bytes:
        return (immovable(task, things, renderer) or "").encode()


def settle(parts: BuildFolder, task: Task, stuck: str, things: Library) -> None:
    """Write down that a task is kept, or that its place goes on after it."""
    attempt = Attempt.of_task(task)
    first = task.seed - attempt.number
    for seed in range(first, task.seed):
        parts.add(attempt.place, CandidateLog(task.question_type, seed, EARLIER, None, "", 0.0))
    if not stuck:
        parts.keep(attempt.place, task, things)
    check = IMMOVABLE if stuck else KEPT
    parts.add(attempt.place, CandidateLog(task.question_type, task.seed, check, None, stuck, 0.0))


def unsettled(parts: BuildFolder, suite: Suite) -> list[Task]:
    """The tasks of which nothing is written down yet."""
    places = {task.id: Attempt.of_task(task).place for task in suite.tasks}
    return [
        task
        for task in suite.tasks
        if task.seed not in {line.seed for line in parts.log(places[task.id])}
    ]


def rebuild_command(suite: Suite, path: Path, pool: Pool) -> str:
    """What makes the rest.

    Raises:
        BadData: Its places aren't numbered in a row from the same number on in each type.
    """
    counts = Counter(task.question_type for task in suite.tasks)
    first = min(task.seed for task in suite.tasks) // ATTEMPTS
    for name, count in counts.items():
        mine = [task.seed // ATTEMPTS for task in suite.tasks if task.question_type == name]
        if mine != list(range(first, first + count)):
            raise BadData(suite.name, f"its {name} tasks aren't places {first} and on", "Say which")
    asked = " ".join(f"--counts.{name} {count}" for name, count in counts.items())
    rules = f"--rules {suite.tasks[0].version}"
    return f"probe suite build {path} --public {rules} --pool {pool} --first {first} {asked}"


def main(
    suite: Annotated[str, tyro.conf.Positional],
    path: Annotated[Path, tyro.conf.Positional],
    pool: Pool = "procedural",
    workers: int = 2,
) -> None:
    """Check the tasks of a suite and begin the next version's build.

    Args:
        suite: A public suite.
        path: File that the next version will have; its build's folder is beside it.
        pool: What the suite was made of.
        workers: Processes.
    """
    frozen, things = find_suite(suite), library(pool)
    command = rebuild_command(frozen, path, pool)
    parts = BuildFolder(path.with_suffix(".parts"))
    begin(parts, pool, public=True, unchecked=False, rules=frozen.tasks[0].version)
    _check(parts, frozen, MovableChecker(pool), LocalEngine(workers), things)
    if left := unsettled(parts, frozen):
        say(f"{len(left)} tasks weren't checked; give the same command again")
        return
    for task in frozen.tasks:
        line = parts.log(Attempt.of_task(task).place)[task.seed % ATTEMPTS]
        if line.check != KEPT:
            say(f"{task.id} is made anew: {line.detail}")
    say(f"Now: {command}")


def _check(
    parts: BuildFolder, frozen: Suite, checker: MovableChecker, engine: LocalEngine, things: Library
) -> None:
    waiting: Sequence[Task] = unsettled(parts, frozen)
    plan = WorkPlan(f"movable-{content_hash(frozen)[:32]}", checker, waiting, lambda t: t.id)
    with bar() as progress, closing(engine.carry_out(plan)) as results:
        line = progress.add_task("Checking", total=len(waiting))
        for task, result in results:
            if not isinstance(result, LostUnit):
                settle(parts, task, result.decode(), things)
            progress.advance(line)


if __name__ == "__main__":
    tyro.cli(main)
