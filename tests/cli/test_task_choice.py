"""Which tasks `probe run --limit --type --task` leaves of a suite."""

from __future__ import annotations

import pytest

from probe.cli.task_choice import TaskChoice
from probe.errors import BadData, UnknownName
from probe.tasks.identity import identity_of
from probe.tasks.suite_file import demo_suite, packaged_suite

DEMO = demo_suite()


def test_without_a_choice_it_is_the_suite_itself():
    assert TaskChoice().of(DEMO) is DEMO


def test_a_limit_takes_tasks_from_all_over_the_suite_in_its_order():
    v1 = packaged_suite("v1")
    few = TaskChoice(limit=6).of(v1)
    places = [v1.tasks.index(task) for task in few.tasks]
    assert places == [0, 25, 50, 75, 100, 125]
    assert len({task.question_type for task in few.tasks}) >= 5
    assert set(few.objects) == {it.object_id for task in few.tasks for it in task.scene.objects}
    assert "6 of the 150 tasks of v1: not a score on v1" in identity_of(few).remark


def test_more_than_there_are_is_all():
    assert TaskChoice(limit=1000).of(DEMO).tasks == DEMO.tasks


def test_types_and_limit_go_together():
    chosen = TaskChoice(limit=2, type=("count", "find")).of(packaged_suite("v1"))
    assert [task.question_type for task in chosen.tasks] == ["count", "find"]


def test_tasks_by_id_stand_in_the_suites_order():
    ids = [task.id for task in DEMO.tasks]
    assert [it.id for it in TaskChoice(task=(ids[4], ids[1])).of(DEMO).tasks] == [ids[1], ids[4]]


def test_what_names_nothing_is_refused():
    with pytest.raises(UnknownName, match="no task called"):
        TaskChoice(task=("none",)).of(DEMO)
    with pytest.raises(BadData, match="--type: suite v1 has no task of it. It has: beneath, comp"):
        TaskChoice(type=("behind",)).of(packaged_suite("v1"))
    with pytest.raises(BadData, match="--task: does nothing with --limit"):
        TaskChoice(limit=1, task=(DEMO.tasks[0].id,)).of(DEMO)
