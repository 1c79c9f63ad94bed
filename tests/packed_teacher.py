"""The scripted teacher's episodes that are packed in runs/data."""

from __future__ import annotations

import tarfile
from pathlib import Path

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.train.collect.batches import Batch, batches

_PACKED = Path(__file__).parents[1] / "runs/data/teacher.tar.xz"


def packed_batches(folder: Path) -> list[Batch]:
    """All batches, unpacked into a folder."""
    with tarfile.open(_PACKED) as archive:
        archive.extractall(folder, filter="data")
    return batches(folder / "collected")


def packed_episodes(folder: Path) -> list[tuple[Task, EpisodeRecord]]:
    """Those of the first batch, with their tasks."""
    return episodes_of(packed_batches(folder)[0])


def episodes_of(batch: Batch) -> list[tuple[Task, EpisodeRecord]]:
    """A batch's episodes with their tasks."""
    tasks = {task.id: task for task in read_suite(batch.folder / SUITE).tasks}
    records = read_records(batch.setting("agentic") / RECORDS)
    return [(tasks[record.task], record) for record in records]
