"""Run folders that tests make by hand, with plain pictures in place of drawn ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image

from probe.episodes.conditions import RendererKind
from probe.episodes.files import write_records
from probe.episodes.film import FRAMES
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import question_of
from probe.episodes.perceptions import PerceptionUsed
from probe.episodes.record import End, EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call
from probe.files import encode, write_bytes, write_picture
from probe.report.page import PICTURES
from probe.report.stills import file_of, stills_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import demo_suite, write_suite
from probe.tasks.task import Letter, Task
from probe.toolshed.result import Answer

DEMO = demo_suite()


def wrong_letter(task: Task) -> Letter:
    return "A" if task.answer != "A" else "B"


def episode(
    task: Task,
    *,
    right: bool = True,
    agent: str = "anna",
    run: int = 0,
    words: str = "I look for it.",
    fault: str | None = None,
) -> EpisodeRecord:
    """A record of four steps in which nothing moves; Find is pointed at nowhere."""
    middle = task.setup.picture_px // 2, task.setup.picture_px // 4
    start, letter = TableState(task.scene, (0.0,) * 6), task.answer if right else wrong_letter(task)
    find = Call.of("find_object", {"description": words}, words)
    grasp = Call.of("grasp_and_remove", {"object_id": words[:40]})
    steps = (
        Step(find, "done", words, middle, start),
        Step(grasp, "failed", words, middle, start),
        Step(Call("push", words), "malformed", words, None, start),
    )
    end: End = "fault" if fault else "answered"
    seconds = Seconds((1.0,) * 3, (2.0,) * 3)
    record = EpisodeRecord(
        task.id, agent, run, question_of(task), start, steps, None, end, fault, seconds,
        viewpoint=task.viewpoint,
    )  # fmt: skip
    if fault:
        return record
    said = (
        {"choice": letter, "point": [10, 20]}
        if task.question_type == "find"
        else {"choice": letter}
    )
    last = Step(Call.of("answer_question", said), "done", "Recorded.", None, start)
    answer = Answer(letter, (10.0, 20.0) if task.question_type == "find" else None)
    return replace(
        record, steps=(*steps, last), answer=answer, seconds=Seconds((1.0,) * 4, (2.0,) * 4)
    )


def on_robot(record: EpisodeRecord, folder: Path) -> EpisodeRecord:
    """A record as a robot leaves it: pictures in place of poses, joints as they were measured."""

    def table(number: int) -> TableState:
        joints = tuple(0.001 * number for _ in record.start.joints)
        return TableState(replace(record.start.scene, objects=()), joints)

    name = f"{FRAMES}/{record.task}-{record.agent}-{record.run}"
    frames = tuple(f"{name}/{number:03d}" for number in range(len(record.steps) + 1))
    for number, frame in enumerate(frames):
        write_picture(folder / f"{frame}.jpg", np.full((1024, 1024, 3), 40 * number, np.uint8))
    steps = tuple(replace(step, after=table(n)) for n, step in enumerate(record.steps, start=1))
    seen = PerceptionUsed("segmenter")
    return replace(record, start=table(0), steps=steps, frames=frames, perception=seen)


def write_run(
    folder: Path, records: Sequence[EpisodeRecord], suite: Suite = DEMO, *, pictures: bool = True
) -> Path:
    """A folder as `probe run` leaves it, and the pictures that a report of it would draw."""
    write_suite(folder / SUITE, suite)
    write_records(folder / RECORDS, records)
    write_pictures(folder, records if pictures else (), suite)
    return folder


def write_pictures(
    folder: Path, records: Sequence[EpisodeRecord], suite: Suite, renderer: RendererKind = "own"
) -> None:
    """Plain pictures, named as those that a report of these records would draw with a renderer."""
    tasks = {task.id: task for task in suite.tasks}
    plain = encode(Image.new("RGB", (1024, 1024), (120, 140, 160)), "WEBP")
    for record in records:
        for still in stills_of(tasks[record.task], record, folder, renderer):
            write_bytes(folder / PICTURES / file_of(still, suite.objects), plain)
