"""Reads what `probe collect` wrote: every episode with its task and what it is worth."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from probe.assets.mesh.fingerprint import Fingerprint, same
from probe.episodes.folder import RECORDS, SUITE
from probe.errors import BadData
from probe.tasks.suite import Suite
from probe.tasks.suite_file import digest_of, read_suite
from probe.train.choose.candidates import EpisodeCandidate
from probe.train.collect.batches import SETTINGS, Batch, EpisodeGrade, batches
from probe.train.collect.settings import read_settings
from probe.transcripts.prompts import Setting


@dataclass(frozen=True)
class _Known:
    """What each id stood for first, and in which folder."""

    tasks: dict[str, tuple[str, Path]] = field(default_factory=dict[str, tuple[str, Path]])
    objects: dict[str, tuple[Fingerprint, Path]] = field(
        default_factory=dict[str, tuple[Fingerprint, Path]]
    )

    def add(self, suite: Suite, folder: Path) -> None:
        """Take in a folder's tasks and objects.

        Raises:
            BadData: One of them is another than that of its id in an earlier folder.
        """
        for task in suite.tasks:
            digest = digest_of(task)
            earlier, where = self.tasks.setdefault(task.id, (digest, folder))
            if digest != earlier:
                reason = f"{task.id} is another task here than in {where}"
                remedy = "Select from one of them alone; elsewhere collect with another --first"
                raise BadData(folder, reason, remedy)
        for id, mark in suite.objects.items():
            before, where = self.objects.setdefault(id, (mark, folder))
            if not same(mark, before):
                reason = f"{id} is another object here than in {where}"
                raise BadData(folder, reason, "Select from one of them alone")


def candidates_of(
    folders: Sequence[Path], objects: dict[str, Fingerprint]
) -> tuple[list[EpisodeCandidate], int]:
    """All graded episodes of some collections.

    Args:
        folders: That `probe collect` wrote.
        objects: Fingerprints of the objects that appear are added to it.

    Returns:
        The episodes, and how many batches were left out, not being whole yet.

    Raises:
        BadData: A folder is no collection, a file can't be read, records and grades differ, or one
            id stands for several tasks or objects.
    """
    found, unfinished, known = list[EpisodeCandidate](), 0, _Known()
    for folder in folders:
        read_settings(folder)
        for batch in batches(folder):
            if batch.whole:
                found += _of_batch(batch, known)
            else:
                unfinished += 1
    if not found:
        names = ", ".join(map(str, folders))
        raise BadData(names, "holds no whole batch", "Let `probe collect` go on")
    objects |= {id: mark for id, (mark, _) in known.objects.items()}
    return found, unfinished


def _of_batch(batch: Batch, known: _Known) -> Iterator[EpisodeCandidate]:
    grades = {(it.task, it.setting, it.run): it for it in batch.grades()}
    for setting in SETTINGS:
        if (batch.setting(setting) / SUITE).exists():
            yield from _of_setting(batch, setting, grades, known)
    if lost := [task for (task, _, _), grade in grades.items() if grade.correct is not None]:
        reason = f"{lost[0]} is graded but has no record"
        raise BadData(batch.folder, reason, "Delete this batch and collect again")


def _of_setting(
    batch: Batch, setting: Setting, grades: dict[tuple[str, str, int], EpisodeGrade], known: _Known
) -> Iterator[EpisodeCandidate]:
    """Takes each grade out that belongs to a record."""
    suite = read_suite(batch.setting(setting) / SUITE)
    known.add(suite, batch.setting(setting))
    tasks = {task.id: task for task in suite.tasks}
    for (task, run), record in batch.records(setting, suite).items():
        grade = grades.pop((task, setting, run), None)
        if grade is None or task not in tasks:
            reason = f"{task}, run {run} isn't graded"
            remedy = "Delete its batch's grades.json and collect again"
            raise BadData(batch.setting(setting) / RECORDS, reason, remedy)
        yield EpisodeCandidate(tasks[task], record, grade.correct)
