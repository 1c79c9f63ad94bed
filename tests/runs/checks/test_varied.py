"""Tasks under other conditions, and tasks that these conditions can't have made."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.episodes.conditions import Conditions
from probe.runs.checks.varied import difference_under
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task

V1 = packaged_suite("v1")
TASK = next(task for task in V1.tasks if task.question_type == "size")
MOVED, JITTER = Conditions(camera="moved"), Conditions(pose_jitter=0.003)


def shifted(task: Task, by: float) -> Task:
    """With each thing so many metres along x."""
    objects = tuple(
        replace(it, pose=replace(it.pose, position=(x + by, y, z)))
        for it in task.scene.objects
        for x, y, z in [it.pose.position]
    )
    return replace(task, scene=replace(task.scene, objects=objects))


def remarked(task: Task, u: int) -> Task:
    """With mark A so many pixels from the left, in the question too."""
    first, second = task.marks
    was, now = f"A at ({first.point[0]}, {first.point[1]})", f"A at ({u}, {first.point[1]})"
    assert was in task.question
    first = replace(first, point=(u, first.point[1]))
    return replace(task, marks=(first, second), question=task.question.replace(was, now))


def other_table(task: Task) -> Task:
    return replace(task, scene=replace(task.scene, table="white_marble"))


@pytest.mark.parametrize(
    ("conditions", "task"),
    [
        (Conditions(), TASK),
        (Conditions(lighting="hdri"), TASK),
        (MOVED, remarked(TASK, 77)),
        (Conditions(table="other"), other_table(TASK)),
        (JITTER, shifted(TASK, 0.003)),
        (Conditions(table="other", pose_jitter=0.003), other_table(shifted(TASK, 0.002))),
    ],
)
def test_what_conditions_change_may_differ(conditions, task):
    assert difference_under(conditions, task, TASK) is None


@pytest.mark.parametrize(
    ("conditions", "task", "words"),
    [
        (MOVED, replace(TASK, answer="B" if TASK.answer == "A" else "A"), "its answer differs"),
        (MOVED, replace(TASK, question="Which is it?"), "its question differs"),
        (MOVED, replace(remarked(TASK, 77), question=TASK.question), "its question differs"),
        (MOVED, replace(TASK, marks=TASK.marks[::-1]), "its marks are on other things"),
        (MOVED, shifted(TASK, 0.001), "its scene differs"),
        (MOVED, other_table(TASK), "its scene differs"),
        (JITTER, shifted(TASK, 0.03), "farther away"),
        (Conditions(), remarked(TASK, 77), "its question differs"),
        (JITTER, replace(TASK, scene=TASK.scene.without(1)), "other things are on its table"),
    ],
)
def test_what_they_do_not_change_may_not(conditions, task, words):
    assert words in (difference_under(conditions, task, TASK) or "")
