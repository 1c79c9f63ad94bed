"""What is kept on disk of one person: finished records, the one under way, remarks. No table."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from probe.episodes.files import line_of, read_records, write_records
from probe.episodes.folder import RECORDS, add_line
from probe.episodes.record import EpisodeRecord
from probe.episodes.remarks import Remark, add_remark, latest, read_remarks
from probe.interfaces.human.names import file_of
from probe.interfaces.human.progress import HumanProgress
from probe.tasks.suite import Suite
from probe.tasks.task import Task

UNFINISHED = "unfinished"
"""Folder beside the records, with a file for each person who is in the middle of a question."""


class Store(Protocol):
    """What a seat is told by and tells of one person; SessionStore says what each part does."""

    @property
    def name(self) -> str: ...

    @property
    def progress(self) -> HumanProgress: ...

    @property
    def remarks(self) -> Mapping[str, Remark]: ...

    def earlier(self, task: Task) -> tuple[EpisodeRecord | None, int]: ...

    def keep(self, record: EpisodeRecord) -> None: ...

    def end(self, record: EpisodeRecord) -> None: ...

    def write(self) -> None: ...

    def remark(self, task: Task, *, ambiguous: bool, note: str) -> None: ...


class SessionStore:
    """One person in a folder of records.

    Args:
        name: The person's.
        suite: What is asked.
        out: A folder that was started for it.

    Attributes:
        name: The person's.
        progress: Which questions are done.
        remarks: What the person said of questions, by task.

    Raises:
        BadData: What is there can't be read.
    """

    def __init__(self, name: str, suite: Suite, out: Path) -> None:
        self.name = name
        records = read_records(out / RECORDS) if (out / RECORDS).exists() else []
        self.progress = HumanProgress(suite.tasks, (r for r in records if r.agent == name))
        said = latest(read_remarks(out))
        self.remarks = {task: remark for (task, who), remark in said.items() if who == name}
        self._out = out
        self._unfinished = out / UNFINISHED / file_of(name)
        self._unwritten: EpisodeRecord | None = None

    def earlier(self, task: Task) -> tuple[EpisodeRecord | None, int]:
        """What has been done in the run of a task that comes next, if anything, and its number.

        Raises:
            BadData: The file can't be read.
        """
        run = self.progress.run_of(task)
        found = read_records(self._unfinished) if self._unfinished.exists() else []
        return next((it for it in found if (it.task, it.run) == (task.id, run)), None), run

    def keep(self, record: EpisodeRecord) -> None:
        """Keep a record that is under way, in place of the one before.

        Raises:
            OutputFailed: It can't be written; the one before is whole.
        """
        write_records(self._unfinished, [record])

    def end(self, record: EpisodeRecord) -> None:
        """Add the record of an episode that has ended to the others.

        Raises:
            OutputFailed: It can't be written; write() tries again.
        """
        self._unwritten = record
        self.write()

    def write(self) -> None:
        """Add a record that couldn't be written when it ended, if there is one; see end()."""
        if self._unwritten is None:
            return
        add_line(self._out, line_of(self._unwritten))
        self.progress.add(self._unwritten)
        self._unwritten = None
        self._unfinished.unlink(missing_ok=True)

    def remark(self, task: Task, *, ambiguous: bool, note: str) -> None:
        """Add what the person says of a question.

        Raises:
            OutputFailed: It can't be written.
        """
        remark = Remark(task.id, self.name, ambiguous, note)
        add_remark(self._out, remark)
        self.remarks[task.id] = remark
