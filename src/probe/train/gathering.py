"""Reads what `probe collect` wrote: every episode with its task and what it is worth."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from probe.assets.fingerprint import Fingerprint
from probe.chat.prompts import Arm
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE, in_order, standing
from probe.errors import BadData
from probe.tasks.suite_file import read_suite
from probe.train.batches import Batch, Grade, batches
from probe.train.selection import Candidate
from probe.train.settings import read_settings

_ARMS: tuple[Arm, ...] = "direct", "agentic"


def candidates_of(
    folders: Sequence[Path], objects: dict[str, Fingerprint]
) -> tuple[list[Candidate], int]:
    """All graded episodes of some collections.

    Args:
        folders: That `probe collect` wrote.
        objects: Fingerprints of the objects that appear are added to it.

    Returns:
        The episodes, and how many batches were left out, not being whole yet.

    Raises:
        BadData: A folder is no collection, a file can't be read, or records and grades differ.
    """
    found, unfinished = list[Candidate](), 0
    for folder in folders:
        read_settings(folder)
        for batch in batches(folder):
            if batch.whole:
                found += _of_batch(batch, objects)
            else:
                unfinished += 1
    if not found:
        names = ", ".join(map(str, folders))
        raise BadData(names, "holds no whole batch", "Let `probe collect` go on")
    return found, unfinished


def _of_batch(batch: Batch, objects: dict[str, Fingerprint]) -> Iterator[Candidate]:
    grades = {(it.task, it.arm, it.run): it for it in batch.grades()}
    for arm in _ARMS:
        if (batch.arm(arm) / SUITE).exists():
            yield from _of_arm(batch.arm(arm), grades, objects)
    if grades:
        reason = f"{next(iter(grades))[0]} is graded but has no record"
        raise BadData(batch.folder, reason, "Delete this batch and collect again")


def _of_arm(
    folder: Path, grades: dict[tuple[str, str, int], Grade], objects: dict[str, Fingerprint]
) -> Iterator[Candidate]:
    """Takes each grade out that belongs to a record."""
    suite = read_suite(folder / SUITE)
    objects |= suite.objects
    tasks = {task.id: task for task in suite.tasks}
    for record in standing(in_order(read_records(folder / RECORDS), suite)):
        grade = grades.pop((record.task, record.arm, record.run), None)
        if grade is None or record.task not in tasks:
            reason = f"{record.task}, run {record.run} isn't graded"
            remedy = "Delete its batch's grades.json and collect again"
            raise BadData(folder / RECORDS, reason, remedy)
        yield Candidate(tasks[record.task], record, grade.correct)
