"""Collects a teacher's episodes until enough have succeeded or a budget is spent.

Everything is on disk after each step: who comes back goes on where it stopped. Knows no model: who
plays is an argument.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from probe.assets.library import Library
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, Unsatisfiable
from probe.generation.build import assemble
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.generation.plan import ATTEMPTS
from probe.report.scene_renderer import SceneRenderer
from probe.tasks.suite import Suite, check_objects, selection
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import Task
from probe.train.collect.aim import Aim
from probe.train.collect.batches import (
    SETTINGS,
    TASKS,
    Batch,
    CollectedBatches,
    EpisodeGrade,
    batches,
    collected,
    new_batch,
)
from probe.transcripts.prompts import Setting


class Play(Protocol):
    """Lets the teacher work on a suite in a setting; what is done already isn't done again."""

    def __call__(self, suite: Suite, setting: Setting, runs: int, out: Path) -> Iterable[str]:
        """Yields what became of each episode, in words."""
        ...


Make = Callable[[Sequence[TaskSlot]], Iterable[tuple[TaskSlot, str | None]]]
"""Makes tasks into the folder's parts; yields each place with what went wrong, if it did."""


@dataclass(frozen=True)
class TeacherWorkers:
    """Who does the work.

    Attributes:
        make: Makes tasks.
        play: Plays them.
        library: The objects.
        scene_renderer: Where answers that point at something are graded.
    """

    make: Make
    play: Play
    library: Library
    scene_renderer: Callable[[Suite], SceneRenderer]


@dataclass(frozen=True)
class CollectionProgress:
    """How far it is.

    Attributes:
        so_far: What whole batches have brought.
        doing: What was done last, in words.
    """

    so_far: CollectedBatches
    doing: str


def collect(out: Path, aim: Aim, hands: TeacherWorkers) -> Generator[CollectionProgress]:
    """Collect into a folder; yields after each step.

    Raises:
        Unsatisfiable: No task of a batch could be made.
        BadData: What is there already can't be read, or a batch was begun in other settings.
        OutputFailed: It can't be written.
    """
    for batch in batches(out, aim.shard):
        if not batch.whole:
            suite = read_suite(batch.folder / SUITE)
            check_objects(suite, hands.library)
            _check_begun(batch, aim)
            so_far = collected(batches(out, aim.shard))
            for doing in _played(batch, suite, aim, hands):
                yield CollectionProgress(so_far, doing)
    so_far = collected(batches(out, aim.shard))
    yield CollectionProgress(so_far, "begun")
    while aim.reached(so_far) < aim.total and aim.spent(so_far) is None:
        for doing in _new(out, aim, hands, so_far):
            yield CollectionProgress(so_far, doing)
        so_far = collected(batches(out, aim.shard))
        yield CollectionProgress(so_far, "a batch is done")


def _check_begun(batch: Batch, aim: Aim) -> None:
    """See that whatever was played of a batch is of what is to be played, or it stays ungraded.

    Raises:
        BadData: It was begun with other settings, or with more runs.
    """
    begun = [it for it in SETTINGS if (batch.setting(it) / SUITE).exists()]
    path = batch.setting("direct") / RECORDS
    # A line that was cut off is set aside by whoever plays on.
    known = {it.run for it in read_records(path, whole=False)} if path.exists() else set[int]()
    if not {*begun} <= {*aim.settings} or max(known, default=-1) >= aim.direct_runs:
        reason = f"was begun with episodes that are {' and '.join(begun)}"
        runs = f", {max(known) + 1} runs each" if known else ""
        remedy = f"Say --settings and --direct-runs as then, or delete {batch.folder}"
        raise BadData(batch.folder, f"{reason}{runs}", remedy)


def _new(out: Path, aim: Aim, hands: TeacherWorkers, so_far: CollectedBatches) -> Generator[str]:
    """Make and play one more batch."""
    failures, made = list[str](), list[TaskSlot]()
    parts = BuildFolder(out / TASKS)
    wanted = aim.next_places(so_far, lambda place: parts.is_exhausted(place, ATTEMPTS))
    for place, failure in hands.make(wanted):
        if failure is None:
            made.append(place)
        else:
            failures.append(failure)
        yield f"{len(made)} of {len(wanted)} tasks made"
    if not made:
        raise Unsatisfiable(f"None of {len(wanted)} tasks could be made. {failures[0]}")
    batch = new_batch(out, aim.shard)
    # In the order in which they were wanted: which worker was first mustn't matter.
    assemble(batch.folder / SUITE, parts, sorted(made), hands.library)
    suite = read_suite(batch.folder / SUITE)
    yield from _played(batch, suite, aim, hands)


def _played(batch: Batch, suite: Suite, aim: Aim, hands: TeacherWorkers) -> Generator[str]:
    """Play what a batch lacks and grade it."""
    grades = list[EpisodeGrade]()
    with hands.scene_renderer(suite) as scene_renderer:
        asked_again = suite
        if aim.mode in ("both", "direct"):
            yield from hands.play(suite, "direct", aim.direct_runs, batch.setting("direct"))
            grades += graded(batch, "direct", aim.direct_runs, scene_renderer)
            asked_again = suite if aim.always else _without(suite, grades)
        setting: Setting = "text-only" if aim.mode == "text-only" else "agentic"
        rest = None if aim.mode == "direct" else _begun(batch.setting(setting), asked_again)
        if rest and rest.tasks:
            yield from hands.play(rest, setting, 1, batch.setting(setting))
            grades += graded(batch, setting, 1, scene_renderer)
    batch.keep(grades)


def _begun(folder: Path, suite: Suite) -> Suite:
    """The tasks that are tried with tools, written down; as before, if that was begun.

    An episode without tools that failed by our fault may have been right since.
    """
    if (folder / SUITE).exists():
        return read_suite(folder / SUITE)
    if suite.tasks:
        write_suite(folder / SUITE, suite)
    return suite


def graded(
    batch: Batch, setting: Setting, runs: int, scene_renderer: SceneRenderer
) -> list[EpisodeGrade]:
    """What came of each run of a setting's tasks, also of those that left no record.

    Raises:
        BadData: The suite or a record can't be read.
    """
    suite = read_suite(batch.setting(setting) / SUITE)
    found = batch.records(setting, suite)
    return [
        _grade(task, setting, run, found.get((task.id, run)), scene_renderer)
        for task in suite.tasks
        for run in range(runs)
    ]


def _grade(
    task: Task,
    setting: Setting,
    run: int,
    record: EpisodeRecord | None,
    scene_renderer: SceneRenderer,
) -> EpisodeGrade:
    score = scene_renderer.score(task, record) if record and record.end != "fault" else None
    fault = record.fault if record else "no record was left"
    return EpisodeGrade(
        task=task.id,
        question_type=task.question_type,
        seed=task.seed,
        setting=setting,
        run=run,
        correct=score and score.correct,
        outcome=score.outcome if score else fault or "fault",
        manipulations=record.manipulations if record else 0,
        cost=record.participation.cost if record and record.participation else None,
    )


def _without(suite: Suite, grades: Sequence[EpisodeGrade]) -> Suite:
    """The tasks that weren't right each time."""
    wrong = {grade.task for grade in grades if not grade.correct}
    known = {grade.task for grade in grades}
    left = tuple(task for task in suite.tasks if task.id in wrong or task.id not in known)
    return selection(suite, left, suite.name)
