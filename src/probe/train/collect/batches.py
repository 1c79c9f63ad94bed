"""The folder that episodes are collected in, batch by batch, and what it holds so far.

A batch is a suite of fresh training tasks and a folder of records for each setting, as `probe run`
leaves them. `grades.json` comes last: a batch that has it is whole.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Literal

import pydantic

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE, in_order
from probe.episodes.record import EpisodeRecord
from probe.files import read_document, write_text
from probe.generation.build_folder import TaskSlot
from probe.generation.plan import ATTEMPTS
from probe.runs.checks.folder import check_records
from probe.tasks.suite import Suite
from probe.tasks.task import QuestionType
from probe.transcripts.prompts import Setting
from probe.types import Shard

BATCHES, TASKS, GRADES = "batches", "tasks", "grades.json"
_REMEDY = "Delete it and collect again: the batch's records are graded again"


class EpisodeGrade(
    pydantic.BaseModel,
    extra="forbid",
    frozen=True,
    allow_inf_nan=False,
    validate_by_name=True,
    serialize_by_alias=True,
):
    """What came of one episode.

    Attributes:
        task, question_type, seed: What it was about.
        setting, run: How and which.
        correct: Whether the answer was right, Find's point included; None for our fault.
        outcome: Why.
        manipulations: How many it took.
        cost: US dollars; None where nobody knows.
    """

    task: str
    question_type: Annotated[QuestionType, pydantic.Field(alias="kind")]
    seed: int
    setting: Annotated[str, pydantic.Field(alias="arm")]
    run: int
    correct: bool | None
    outcome: str
    manipulations: int
    cost: float | None


class Grades(pydantic.BaseModel, extra="forbid", frozen=True):
    """Of a whole batch."""

    version: Literal[1] = 1
    grades: tuple[EpisodeGrade, ...]


SETTINGS: tuple[Setting, ...] = "direct", "agentic", "text-only"
"""In which a teacher may play."""


@dataclass(frozen=True)
class Batch:
    """One batch's folder."""

    folder: Path

    def setting(self, setting: Setting) -> Path:
        """Where the records of a setting are."""
        return self.folder / setting

    def records(self, setting: Setting, suite: Suite) -> dict[tuple[str, int], EpisodeRecord]:
        """What a setting's records hold of each task and run: no faults that were made good since.

        Raises:
            BadData: One can't be read, or can't be of a run of the suite.
        """
        path = self.setting(setting) / RECORDS
        records = read_records(path) if path.exists() else []
        check_records(records, suite, path)
        # Faults of ours may tell no setting; they come before what made them good.
        return {(it.task, it.run): it for it in in_order(records, suite)}

    @property
    def whole(self) -> bool:
        """Whether nothing is left to do there."""
        return (self.folder / GRADES).exists()

    def grades(self) -> tuple[EpisodeGrade, ...]:
        """What came of its episodes.

        Raises:
            BadData: The file is missing or broken.
        """
        return read_document(self.folder / GRADES, Grades, _REMEDY, _REMEDY).grades

    def keep(self, grades: Sequence[EpisodeGrade]) -> None:
        """Write down what came of all episodes; the batch is whole then."""
        write_text(self.folder / GRADES, Grades(grades=tuple(grades)).model_dump_json() + "\n")


@dataclass(frozen=True)
class CollectedBatches:
    """What whole batches have brought.

    Attributes:
        tasks: How many were tried, by type.
        successes: How many of these were answered rightly with tools, or each time without, by
            type.
        episodes: How many in all.
        missing: How many came to nothing by our fault.
        right: Episodes that were right, by setting, and all, by setting.
        cost: US dollars in all, of the episodes whose cost is known.
        unpriced: Episodes of which it isn't.
        last: The highest episode number, by type.
    """

    tasks: Counter[str] = field(default_factory=Counter[str])
    successes: Counter[str] = field(default_factory=Counter[str])
    episodes: int = 0
    missing: int = 0
    right: Counter[str] = field(default_factory=Counter[str])
    played: Counter[str] = field(default_factory=Counter[str])
    cost: float = 0.0
    unpriced: int = 0
    last: dict[str, int] = field(default_factory=dict[str, int])


def batches(out: Path, shard: Shard | None = None) -> list[Batch]:
    """Batches whose tasks are made, in order, of one shard or of all."""
    start = f"{_mark(shard)}-" if shard else ""
    found = sorted((out / BATCHES).glob(f"{start}*/{SUITE}"))
    return [Batch(path.parent) for path in found]


def new_batch(out: Path, shard: Shard) -> Batch:
    """A shard's next one, after all that are there; its folder isn't made yet."""
    there = (out / BATCHES).glob(f"{_mark(shard)}-*")
    number = max((int(it.name.rpartition("-")[2]) for it in there), default=-1) + 1
    return Batch(out / BATCHES / f"{_mark(shard)}-{number:05d}")


def collected(some: Iterable[Batch]) -> CollectedBatches:
    """What whole batches have brought together.

    Raises:
        BadData: One's grades can't be read.
    """
    grades = [grade for batch in some if batch.whole for grade in batch.grades()]
    tried = {grade.task: grade for grade in grades}
    ways: dict[tuple[str, str], list[bool]] = {}
    for grade in grades:
        ways.setdefault((grade.task, grade.setting), []).append(grade.correct is True)
    # Without tools one right answer of several is luck, and nothing to learn from.
    solved = {
        task
        for (task, setting), right in ways.items()
        if (all if setting == "direct" else any)(right)
    }
    last: dict[str, int] = {}
    for grade in grades:
        last[grade.question_type] = max(last.get(grade.question_type, 0), grade.seed // ATTEMPTS)
    return CollectedBatches(
        tasks=Counter(grade.question_type for grade in tried.values()),
        successes=Counter(tried[task].question_type for task in solved),
        episodes=len(grades),
        missing=sum(grade.correct is None for grade in grades),
        right=Counter(grade.setting for grade in grades if grade.correct),
        played=Counter(grade.setting for grade in grades),
        cost=sum(grade.cost or 0.0 for grade in grades),
        unpriced=sum(grade.cost is None for grade in grades),
        last=last,
    )


def fresh_places(
    question_type: QuestionType, first: int, shard: Shard, after: int | None
) -> Iterator[TaskSlot]:
    """A shard's places of a type, one after another.

    Args:
        question_type: The type.
        first: Number of the first episode of all shards.
        shard: Which part.
        after: The last one that was used; None if none was.
    """
    episode = first + shard.number if after is None else after + shard.count
    while True:
        yield TaskSlot(question_type, episode)
        episode += shard.count


def _mark(shard: Shard) -> str:
    return f"{shard.number}of{shard.count}"
