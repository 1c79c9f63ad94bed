"""Builds a suite: candidates, their checks, the solvable check; one file a kept task, resumable."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.certify.generate import generate
from probe.certify.plan import ATTEMPTS
from probe.certify.result import Candidate, Rejection
from probe.certify.solve import Trial, trials
from probe.errors import Unsatisfiable
from probe.render.renderer import Renderer
from probe.tasks.suite import freeze
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import QuestionKind, Task

UNSOLVED = "solvable"
"""Name of the check that scripted agents make."""


@dataclass(frozen=True)
class Attempt:
    """One candidate seed and what became of it.

    Attributes:
        result: The task, or the check that it failed.
        trials: What scripted agents made of it; empty if it failed an earlier check.
    """

    seed: int
    result: Candidate | Rejection
    trials: tuple[Trial, ...] = ()


@dataclass(frozen=True)
class Workshop:
    """What tasks are made with."""

    library: Library
    tables: Sequence[str]
    renderer: Renderer


def attempts(kind: QuestionKind, episode: int, workshop: Workshop) -> Iterator[Attempt]:
    """Candidates for one place in a suite, ending with the first that is kept.

    Raises:
        Unsatisfiable: None of ATTEMPTS seeds gave a task.
    """
    for seed in range(episode * ATTEMPTS, (episode + 1) * ATTEMPTS):
        result = generate(kind, seed, workshop.library, workshop.renderer, workshop.tables)
        if isinstance(result, Rejection):
            yield Attempt(seed, result)
            continue
        table = load_table(result.task.scene.table, workshop.library.assets)
        made = trials(result.task, workshop.library, table, workshop.renderer)
        if any(trial.solved for trial in made):
            yield Attempt(seed, result, made)
            return
        yield Attempt(seed, Rejection(UNSOLVED, f"none of {len(made)} attempts"), made)
    raise Unsatisfiable(
        f"No {kind} task in {ATTEMPTS} candidates for place {episode}. "
        "Use a library with more objects that hide and are hidden."
    )


def part_path(parts: Path, kind: QuestionKind, episode: int) -> Path:
    """Where one kept task lies until the suite is whole."""
    return parts / f"{kind}-{episode}.json"


def keep(parts: Path, kind: QuestionKind, episode: int, task: Task, library: Library) -> None:
    """Write one kept task."""
    write_suite(part_path(parts, kind, episode), freeze(f"{kind}-{episode}", (task,), library))


def assemble(
    path: Path, parts: Path, wanted: Sequence[tuple[QuestionKind, int]], library: Library
) -> None:
    """Join the parts of a suite in the order of the types and episodes wanted."""
    files = [part_path(parts, kind, episode) for kind, episode in wanted]
    tasks = tuple(task for file in files for task in read_suite(file).tasks)
    write_suite(path, freeze(path.stem, tasks, library))
