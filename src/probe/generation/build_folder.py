"""The folder in which a suite grows: a log and a file a place, so that any number may work on it.

A place is one task to be made: a type and the number of its episode. Its log has a line for every
candidate, written when that is settled; whoever comes back goes on after the last.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import pydantic

from probe.assets.library import Library
from probe.errors import BadData
from probe.files import claim_folder, make_private, read_document, write_text
from probe.reading import words
from probe.scene.setup_file import SetupDocument
from probe.tasks.suite import freeze
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import QuestionType, RulesVersion, Task
from probe.texts import cell, uncell

KEPT, UNSOLVED, RESTLESS, LOOK_ALIKE, UNVERIFIED, IMMOVABLE, REPEATED = (
    "kept",
    "solvable",
    "at rest",
    "look-alikes",
    "verified",
    "movable",
    "repeated",
)
"""Names of results: a task; a candidate that failed only the scripted agents' check; one whose
things move once its table stands alone; one whose answer looks like another candidate; one of which
another measurement finds something wrong; one in which something that has to go can't be moved; one
that asks about the same things as another."""

_UNTRIED = "-"
_MAKING = "making.json"
_REMEDY = "Build into another file"


class TaskSlot(NamedTuple):
    """One task to be made."""

    question_type: QuestionType
    episode: int


class BuildSettings(pydantic.BaseModel, extra="forbid", frozen=True):
    """How all tasks of a folder are made.

    Attributes:
        pool: Which objects appear.
        unchecked: Whether tasks aren't measured once more, and nobody tries to solve them.
        commitment: To a private suite's salt; None for a public suite, as in older folders.
        setup: The table; None for the usual one.
        rules: The version of the rules; folders of before it was written down have the first.
    """

    pool: str
    unchecked: bool
    commitment: str | None = None
    setup: SetupDocument | None = pydantic.Field(default=None, exclude_if=lambda it: it is None)
    rules: RulesVersion = pydantic.Field(default=2, exclude_if=lambda it: it == 2)


@dataclass(frozen=True)
class CandidateLog:
    """What became of one candidate.

    Attributes:
        question_type, seed: The type, and the seed that the task bears or would have borne.
        check: KEPT, or the check that it failed.
        solved: Whether the very first scripted attempt succeeded; None if none was made.
        detail: What was measured, for people.
        seconds: Time that it took.
    """

    question_type: str
    seed: int
    check: str
    solved: bool | None
    detail: str
    seconds: float

    def __str__(self) -> str:
        """Separated by tabs."""
        solved = _UNTRIED if self.solved is None else str(self.solved)
        detail = " ".join(self.detail.split())
        cells = (
            self.question_type,
            self.seed,
            self.check,
            solved,
            cell(detail),
            f"{self.seconds:.1f}",
        )
        return "\t".join(str(each) for each in cells)

    @staticmethod
    def parse(text: str) -> CandidateLog:
        """The line of a log.

        Raises:
            ValueError: It is none.
        """
        question_type, seed, check, solved, detail, seconds = text.split("\t")
        tried = None if solved == _UNTRIED else solved == "True"
        return CandidateLog(question_type, int(seed), check, tried, uncell(detail), float(seconds))


@dataclass(frozen=True)
class BuildFolder:
    """The folder."""

    folder: Path

    def claim(self, making: BuildSettings) -> None:
        """Begin the folder, or see that it was begun in this way; a private suite's is its owner's.

        Raises:
            BadData: It was begun otherwise.
            OutputFailed: It can't be written.
        """
        private = making.commitment is not None
        claim_folder(self.folder / _MAKING, making, _REMEDY, private=private)
        if private:
            make_private(self.folder)

    def making(self) -> BuildSettings | None:
        """How its tasks are made; None if nothing was begun there.

        Raises:
            BadData: That can't be read.
        """
        path = self.folder / _MAKING
        return read_document(path, BuildSettings, _REMEDY) if path.exists() else None

    @property
    def is_private(self) -> bool:
        """Whether its files are for its owner alone.

        Raises:
            BadData: How it was begun can't be read.
        """
        making = self.making()
        return making is not None and making.commitment is not None

    def task_path(self, place: TaskSlot) -> Path:
        """Where a place's task lies once it is made."""
        return self._path(place, "json")

    def log_path(self, place: TaskSlot) -> Path:
        """Where a place's log lies."""
        return self._path(place, "tsv")

    def log(self, place: TaskSlot) -> list[CandidateLog]:
        """What was tried for a place.

        Raises:
            BadData: The log can't be read.
        """
        file = self.log_path(place)
        try:
            lines = words(file).splitlines() if file.exists() else []
            return [CandidateLog.parse(line) for line in lines]
        except (OSError, ValueError) as error:
            raise BadData(file, str(error), "Delete it; its place is then made anew") from error

    def add(self, place: TaskSlot, line: CandidateLog) -> None:
        """Add a line to a place's log; whole or not at all.

        A candidate that is there already counts once: two processes may be at the same place.
        """
        before = self.log(place)
        if line.seed in {each.seed for each in before}:
            return
        self._write_log(place, [*before, line])

    def _write_log(self, place: TaskSlot, lines: Sequence[CandidateLog]) -> None:
        text = "".join(f"{line}\n" for line in lines)
        write_text(self.log_path(place), text, private=self.is_private)

    def is_exhausted(self, place: TaskSlot, attempts: int) -> bool:
        """Whether all of so many candidates were tried for a place in vain."""
        log = self.log(place)
        return len(log) >= attempts and not self.task_path(place).exists()

    def keep(self, place: TaskSlot, task: Task, library: Library) -> None:
        """Write a place's task."""
        suite = freeze(f"{place.question_type}-{place.episode}", (task,), library)
        write_suite(self.task_path(place), suite, private=self.is_private)

    def turn_back(self, place: TaskSlot, task: Task, reason: str) -> None:
        """Reject a place's task after all; the place is filled from the next candidate on.

        Nothing is done if another process has turned it back already.
        """
        *before, last = self.log(place)
        if last.check != KEPT or last.seed != task.seed:
            return
        # In this order: a task without its line would be taken for a good one.
        self.task_path(place).unlink(missing_ok=True)
        self._write_log(place, [*before, replace(last, check=REPEATED, detail=reason)])

    def keep_unsolved(self, task: Task, library: Library) -> None:
        """Write a candidate that failed only the scripted agents' check."""
        suite = freeze(f"unsolved-{task.question_type}-{task.seed}", (task,), library)
        write_suite(self.folder / f"{suite.name}.json", suite, private=self.is_private)

    def packed(self, place: TaskSlot) -> dict[str, str]:
        """What is there of a place, file by file; for a machine that doesn't see the folder."""
        files = [self.log_path(place), self.task_path(place)]
        files += [self._unsolved_path(line) for line in self.log(place) if line.check == UNSOLVED]
        return {file.name: words(file) for file in files if file.exists()}

    def unpack(self, files: Mapping[str, str]) -> None:
        """Take in what packed() gave, whole file by whole file; a task comes after its log."""
        for name, text in files.items():
            write_text(self.folder / name, text, private=self.is_private)

    def unsolved(self, places: Sequence[TaskSlot]) -> Iterator[Task]:
        """The candidates of some places that failed only the scripted agents' check."""
        for place in places:
            for line in self.log(place):
                if line.check == UNSOLVED:
                    yield from read_suite(self._unsolved_path(line)).tasks

    def _unsolved_path(self, line: CandidateLog) -> Path:
        return self.folder / f"unsolved-{line.question_type}-{line.seed}.json"

    def _path(self, place: TaskSlot, suffix: str) -> Path:
        return self.folder / f"{place.question_type}-{place.episode}.{suffix}"
