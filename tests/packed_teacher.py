"""The scripted teacher's episodes that are packed in runs/data."""

from __future__ import annotations

import tarfile
from collections.abc import Sequence
from pathlib import Path

from probe.agents.reading import read_graph
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.train.collect.batches import Batch, batches

_DATA = Path(__file__).parents[1] / "runs/data"
_PACKED = ("teacher.tar.xz", "reduce.tar.xz")


def packed_batches(folder: Path) -> list[Batch]:
    """All batches, unpacked into a folder."""
    for name in _PACKED:
        with tarfile.open(_DATA / name) as archive:
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


def all_episodes(folder: Path) -> list[tuple[Task, EpisodeRecord]]:
    """Those of all batches, with their tasks."""
    return [each for batch in packed_batches(folder) for each in episodes_of(batch)]


def some_of_each_type(folder: Path) -> list[tuple[Task, EpisodeRecord]]:
    """Some six episodes of each type, from all batches."""
    found = all_episodes(folder)
    kinds = sorted({task.question_type for task, _ in found})
    of_a_kind = ([it for it in found if it[0].question_type == kind] for kind in kinds)
    return [each for some in of_a_kind for each in some[:: len(some) // 6]]


def names_in(record: EpisodeRecord) -> list[list[str | None]]:
    """Names in each of its lists, in order."""
    graphs = (read_graph(it.text) for it in record.steps if it.call.name == "perceive_scene")
    return [[seen.name for seen in graph.objects] for graph in graphs]


def said_in(record: EpisodeRecord) -> str:
    """Question, options, words, calls and replies."""
    return "\n".join(
        [record.question.text, *(text for _, text in record.question.options)]
        + [f"{step.call.words}\n{step.call.arguments}\n{step.text}" for step in record.steps]
    )


def right_darker(
    episodes: Sequence[tuple[Task, EpisodeRecord]],
) -> tuple[Task, EpisodeRecord]:
    """The first right episode of Compare that asks for the darker one, and its task."""
    return next(
        (task, record)
        for task, record in episodes
        if task.form == "darker" and record.answer and record.answer.choice == task.answer
    )
