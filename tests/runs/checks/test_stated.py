"""What a record says of its pictures has to fit its task and its conditions."""

from dataclasses import replace

import pytest

from probe.episodes.conditions import Conditions
from probe.episodes.grading import question_of
from probe.episodes.record import EpisodeRecord, TableState
from probe.runs.checks.stated import amiss_as_stated
from probe.scene.lighting import Lighting, lighting_of
from probe.scene.setup import ROOM_TABLE
from probe.tasks.suite_file import demo_suite

OLD = demo_suite().tasks[0]
NEW = replace(OLD, scene=replace(OLD.scene, setup=ROOM_TABLE))


def record(task, **changes):
    start = TableState(task.scene, (0.0,) * 6)
    made = EpisodeRecord(task.id, "a", 0, question_of(task), start, (), None, "stopped")
    return replace(made, viewpoint=replace(task.viewpoint, **changes))


@pytest.mark.parametrize("task", [OLD, NEW])
def test_a_task_seen_as_it_was_frozen_is_in_order(task):
    assert list(amiss_as_stated(record(task))) == []


def test_another_light_than_the_tasks_is_amiss():
    day = lighting_of("day_room", OLD.scene.table)
    assert "its light isn't that of its conditions" in amiss_as_stated(record(OLD, lighting=day))
    # Another day room than the one in which its table stands is another light, too.
    assert record(NEW).viewpoint.lighting == day
    other = Lighting("day_room_1" if day.name == "day_room_0" else "day_room_0")
    assert "its light isn't that of its conditions" in amiss_as_stated(record(NEW, lighting=other))


def test_a_renderer_that_nobody_chose_is_amiss():
    seen = record(NEW, renderer="blender")
    assert "its renderer isn't that of its conditions" in amiss_as_stated(seen)
    chosen = replace(seen, conditions=Conditions(renderer="blender"))
    assert list(amiss_as_stated(chosen)) == []
