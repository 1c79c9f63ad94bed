"""Honest records that tests make by hand, and ways to forge them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import question_of
from probe.episodes.ordered import note_ordered
from probe.episodes.record import EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call
from probe.scene.scene import Scene
from probe.tasks.suite_file import write_suite
from probe.tasks.task import Task
from probe.toolshed.result import Answer
from probe.types import Pose
from run_folders import DEMO

Forgery = Callable[[EpisodeRecord], EpisodeRecord]

TASK = next(task for task in DEMO.tasks if task.question_type == "find")
LOOK = Call.of("perceive_scene")
GRASP = Call.of("grasp_and_remove", {"object_id": "object_1"})


def moved(scene: Scene, instance: int) -> Scene:
    """A scene in which one thing is elsewhere."""
    away = Pose((0.21, -0.2, 0.03))
    objects = tuple(
        replace(it, pose=away) if it.instance == instance else it for it in scene.objects
    )
    return replace(scene, objects=objects)


def honest(task: Task = TASK) -> EpisodeRecord:
    """Look, find, take away, answer; a thing has moved after the grasp."""
    start = TableState(task.scene, (0.0,) * 6)
    after = TableState(moved(task.scene, task.scene.objects[0].instance), (0.1,) * 6)
    find = Call.of("find_object", {"description": "red mug"})
    said = Call.of("answer_question", {"choice": task.answer, "point": [100, 200]})
    steps = (
        Step(LOOK, "done", "objects: []", None, start),
        Step(find, "done", "object_id: object_1", (5, 5), start),
        Step(GRASP, "done", "Done: it is in the basket.", (5, 5), after),
        Step(said, "done", "Your answer is recorded; the episode has ended.", None, after),
    )
    answer, seconds = Answer(task.answer, (100.0, 200.0)), Seconds((1.0,) * 4, (2.0,) * 4)
    asked = question_of(task)
    return EpisodeRecord(task.id, "anna", 0, asked, start, steps, answer, "answered", None, seconds)


def write_folder(out: Path, *records: EpisodeRecord) -> Path:
    """A folder as `probe run` leaves it, two runs of each task having been ordered."""
    write_suite(out / SUITE, DEMO)
    write_records(out / RECORDS, records)
    note_ordered(out, "anna", "", 2)
    return out


def with_step(record: EpisodeRecord, number: int, **changes: object) -> EpisodeRecord:
    """The record with one step, counted from 0, changed."""
    steps = list(record.steps)
    steps[number] = replace(steps[number], **changes)  # type: ignore[arg-type]
    return replace(record, steps=tuple(steps))


def with_steps(record: EpisodeRecord, *steps: Step) -> EpisodeRecord:
    """The record with other steps, and as many times."""
    times = (1.0,) * len(steps)
    return replace(record, steps=steps, seconds=Seconds(times, times))
