"""Episodes that fail on our side: tried three times, then missing in words."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, cast

import pytest

from deadly_work import Deadly
from probe.engines.local import LocalEngine
from probe.episodes.conditions import Conditions
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.grading import question_of
from probe.episodes.record import TableState
from probe.errors import OutputFailed
from probe.render.renderers import Renderers
from probe.runs.plan import Job, RunOrder
from probe.runs.run import RunStart, work
from probe.runs.work import WorkerSetup, stopped
from probe.station.ur5 import Ur5
from probe.tasks.suite_file import demo_suite
from probe.types import Pose

TASK = demo_suite().tasks[0]
ORDER = RunOrder("anna", conditions=Conditions(ideal="grasp"))
NOWHERE = cast(Any, None)


class Broken:
    """Agents that can't be made; counts how often somebody asked for one."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str, int]] = []

    def agent(self, name, task, run, library, renderer):
        self.asked.append((name, task.id, run))
        raise ValueError("no such agent")


def test_an_episode_that_fails_is_tried_three_times(tmp_path):
    broken = Broken()
    place = WorkerSetup(ORDER, NOWHERE, broken.agent)
    (tmp_path / RECORDS).write_bytes(place._line(NOWHERE, Renderers(), Job(TASK, 2)))
    assert broken.asked == [("anna", TASK.id, 2)] * 3
    (record,) = read_records(tmp_path / RECORDS)
    assert (record.end, record.fault) == ("fault", "ValueError: no such agent")
    assert (record.task, record.agent, record.run) == (TASK.id, "anna", 2)
    assert (record.conditions, record.question) == (ORDER.conditions, question_of(TASK))
    assert record.start.scene == TASK.scene
    assert record.start.joints == tuple(Ur5().parked)


def test_a_full_disk_is_no_fault_of_the_episode():
    def full(*_: object) -> Any:
        raise OutputFailed("/cache/x.npz", "No space left on device")

    with pytest.raises(OutputFailed, match="No space left"):
        WorkerSetup(ORDER, NOWHERE, full)._line(NOWHERE, Renderers(), Job(TASK, 0))


@pytest.mark.slow
def test_an_episode_that_kills_its_workers_is_recorded_as_missing(tmp_path):
    start = RunStart("name", (Job(TASK, 0), Job(TASK, 1)), 0, None)
    found = list(work(tmp_path, start, Deadly(ORDER, NOWHERE, NOWHERE), LocalEngine(2)))
    words = "A worker process was killed by signal 9 (SIGKILL) at it, 3 times in all"
    assert sorted((job.run, fault) for job, fault in found) == [(0, words), (1, words)]
    records = read_records(tmp_path / RECORDS)
    assert {(record.run, record.end, record.fault) for record in records} == {
        (0, "fault", words),
        (1, "fault", words),
    }


class Unwritable(WorkerSetup):
    """Its episodes end with a thing that is nowhere."""

    def played(self, job, things, renderer):
        record = stopped(job, self.order)
        placed = replace(TASK.scene.objects[0], pose=Pose((math.nan, 0.0, 0.0)))
        return replace(record, start=TableState(replace(TASK.scene, objects=(placed,)), ()))


def test_a_record_that_cannot_be_written_down_is_a_fault(tmp_path):
    place = Unwritable(ORDER, NOWHERE, NOWHERE)
    (tmp_path / RECORDS).write_bytes(place._line(NOWHERE, Renderers(), Job(TASK, 0)))
    (record,) = read_records(tmp_path / RECORDS)
    assert record.end == "fault" and "position" in (record.fault or "")
