"""Records of run folders, with their tasks and what they are worth."""

from __future__ import annotations

from pathlib import Path

from probe.cli.screen import track
from probe.cli.surroundings import everything
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE, in_order
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.report.darkroom import Darkroom
from probe.scene.scene import Scene
from probe.tasks.grading import Score
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task

Graded = tuple[Task, EpisodeRecord, Score]


def graded(out: Path) -> list[Graded]:
    """Every record of a folder with its task and what it is worth, by task, agent and run.

    Raises:
        BadData: The suite or a record can't be read, or a record is about something else.
        OtherTask: A task has changed since.
    """
    suite = read_suite(out / SUITE)
    with darkroom_of(suite) as darkroom:
        return grade_folder(out, suite, darkroom)


def darkroom_of(suite: Suite) -> Darkroom:
    """A place to draw a suite's tables in, with all objects that suites are made of."""
    return Darkroom(suite, everything)


def grade_folder(out: Path, suite: Suite, darkroom: Darkroom) -> list[Graded]:
    """As `graded`, of a suite that has been read; each task's objects are loaded but once."""
    tasks = {task.id: task for task in suite.tasks}
    records = in_order(read_records(out / RECORDS), suite)
    for record in records:
        if record.task not in tasks:
            remedy = "Move one of them elsewhere"
            raise BadData(out / RECORDS, f"{record.task} is not in {SUITE}", remedy)
        _check_things(out / RECORDS, record, tasks[record.task])
    places = sorted(range(len(records)), key=lambda place: records[place].task)
    scores = {
        place: darkroom.score(tasks[records[place].task], records[place])
        for place in track(places, f"Grading {out.name}")
    }
    return [(tasks[it.task], it, scores[place]) for place, it in enumerate(records)]


def _check_things(path: Path, record: EpisodeRecord, task: Task) -> None:
    """See that a record's scenes hold what its task's does: nobody takes anything off a table.

    Raises:
        BadData: They don't.
    """
    there = _things(task.scene)
    for number, scene in enumerate(record.scenes):
        if _things(scene) != there:
            when = f"after call {number}" if number else "at the start"
            reason = (
                f"{record.task}, run {record.run}: {when} there are other objects than in {SUITE}"
            )
            raise BadData(path, reason, "Delete this line and run the episode again")


def _things(scene: Scene) -> set[tuple[int, str]]:
    return {(placed.instance, placed.object_id) for placed in scene.objects}
