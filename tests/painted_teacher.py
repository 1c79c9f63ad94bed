"""An episode of the scripted teacher at a painted table, without physics."""

from __future__ import annotations

from dataclasses import replace

from probe.episodes.grading import question_of
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import EpisodeRecord
from probe.episodes.run import run_episode
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.tasks.suite_file import packaged_suite
from probe.toolshed.toolshed import Toolshed
from probe.train.collect.teacher import TEACHER, teacher
from tabletops import Block, Obedient, PaintedStation, spec

SIZE = next(task for task in packaged_suite("v1").tasks if task.question_type == "size")
SPECS = {1: spec("red mug", "red"), 2: spec("blue book", "blue"), 3: spec("white ball", "white")}


def taught() -> EpisodeRecord:
    """The teacher compares two marked things at a painted table; a ball lies on one of them."""
    (a, b) = (mark.point for mark in SIZE.marks)
    station = PaintedStation(
        [
            Block(1, (a[0] - 130, a[1] - 50, a[0] + 19, a[1] + 49), 0.02),
            Block(2, (b[0] - 60, b[1] - 30, b[0] + 59, b[1] + 29), 0.02, (30, 60, 150)),
            Block(3, (a[0] - 180, a[1] - 100, a[0] - 11, a[1] + 99), 0.08, (240, 240, 240)),
        ]
    )
    tools = Toolshed(station, Oracle(SPECS), Obedient(), UR5_TABLE, pictures=False)
    agent = teacher(SIZE, 0, "0-1000")
    record = run_episode(SIZE.id, question_of(SIZE), agent, tools, station, agent_name=TEACHER)
    replies = tuple(ModelReply(1) for _ in record.steps)
    return replace(record, participation=Participation("text-only", "0-1000", replies))
