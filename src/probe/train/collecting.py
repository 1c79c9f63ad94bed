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
from probe.certify.build import assemble
from probe.certify.parts import Parts, Place
from probe.chat.prompts import Arm
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE, in_order, standing
from probe.errors import Unsatisfiable
from probe.report.darkroom import Darkroom
from probe.tasks.suite import Suite, check_objects, selection
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import Task
from probe.train.aim import Aim
from probe.train.batches import TASKS, Batch, Grade, Harvest, batches, harvest, new_batch


class Play(Protocol):
    """Lets the teacher work on a suite in an arm; what is done already isn't done again."""

    def __call__(self, suite: Suite, arm: Arm, runs: int, out: Path) -> Iterable[str]:
        """Yields what became of each episode, in words."""
        ...


Make = Callable[[Sequence[Place]], Iterable[tuple[Place, str | None]]]
"""Makes tasks into the folder's parts; yields each place with what went wrong, if it did."""


@dataclass(frozen=True)
class Hands:
    """Who does the work.

    Attributes:
        make: Makes tasks.
        play: Plays them.
        library: The objects.
        darkroom: Where answers that point at something are graded.
    """

    make: Make
    play: Play
    library: Library
    darkroom: Callable[[Suite], Darkroom]


@dataclass(frozen=True)
class Progress:
    """How far it is.

    Attributes:
        so_far: What whole batches have brought.
        doing: What was done last, in words.
    """

    so_far: Harvest
    doing: str


def collect(out: Path, aim: Aim, hands: Hands) -> Generator[Progress]:
    """Collect into a folder; yields after each step.

    Raises:
        Unsatisfiable: No task of a batch could be made.
        BadData: What is there already can't be read.
        OutputFailed: It can't be written.
    """
    for batch in batches(out, aim.shard):
        if not batch.whole:
            suite = read_suite(batch.folder / SUITE)
            check_objects(suite, hands.library)
            for doing in _played(batch, suite, aim, hands):
                yield Progress(harvest(batches(out, aim.shard)), doing)
    so_far = harvest(batches(out, aim.shard))
    yield Progress(so_far, "begun")
    while aim.reached(so_far) < aim.total and aim.spent(so_far) is None:
        for doing in _new(out, aim, hands, so_far):
            yield Progress(so_far, doing)
        so_far = harvest(batches(out, aim.shard))
        yield Progress(so_far, "a batch is done")


def _new(out: Path, aim: Aim, hands: Hands, so_far: Harvest) -> Generator[str]:
    """Make and play one more batch."""
    wanted, failures, made = aim.next_places(so_far), list[str](), list[Place]()
    for place, failure in hands.make(wanted):
        if failure is None:
            made.append(place)
        else:
            failures.append(failure)
        yield f"{len(made)} of {len(wanted)} tasks made"
    if not made:
        raise Unsatisfiable(f"None of {len(wanted)} tasks could be made. {failures[0]}")
    batch, parts = new_batch(out, aim.shard), Parts(out / TASKS)
    # In the order in which they were wanted: which worker was first mustn't matter.
    assemble(batch.folder / SUITE, parts, sorted(made), hands.library)
    suite = read_suite(batch.folder / SUITE)
    yield from _played(batch, suite, aim, hands)


def _played(batch: Batch, suite: Suite, aim: Aim, hands: Hands) -> Generator[str]:
    """Play what a batch lacks and grade it."""
    grades = list[Grade]()
    with hands.darkroom(suite) as darkroom:
        rest = suite
        if aim.mode != "agentic":
            yield from hands.play(suite, "direct", aim.direct_runs, batch.arm("direct"))
            grades += graded(batch.arm("direct"), darkroom)
            rest = suite if aim.always else _without(suite, grades)
        if aim.mode != "direct" and rest.tasks:
            write_suite(batch.arm("agentic") / SUITE, rest)
            yield from hands.play(rest, "agentic", 1, batch.arm("agentic"))
            grades += graded(batch.arm("agentic"), darkroom)
    batch.keep(grades)


def graded(folder: Path, darkroom: Darkroom) -> list[Grade]:
    """What the records of a folder are worth.

    Raises:
        BadData: The suite or a record can't be read.
    """
    suite = read_suite(folder / SUITE)
    tasks = {task.id: task for task in suite.tasks}
    records = standing(in_order(read_records(folder / RECORDS), suite))
    found = list[Grade]()
    for record in records:
        task: Task = tasks[record.task]
        score = None if record.end == "fault" else darkroom.score(task, record)
        found.append(
            Grade(
                task=task.id,
                kind=task.kind,
                seed=task.seed,
                arm=record.arm,
                run=record.run,
                correct=score and score.correct,
                outcome=score.outcome if score else record.fault or "fault",
                manipulations=record.manipulations,
                cost=record.seat.cost if record.seat else None,
            )
        )
    return found


def _without(suite: Suite, grades: Sequence[Grade]) -> Suite:
    """The tasks that weren't right each time."""
    wrong = {grade.task for grade in grades if not grade.correct}
    known = {grade.task for grade in grades}
    left = tuple(task for task in suite.tasks if task.id in wrong or task.id not in known)
    return selection(suite, left, suite.name)
