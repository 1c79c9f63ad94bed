"""Whether a task under other conditions can have been made from the packaged one."""

from __future__ import annotations

from dataclasses import replace

from probe.episodes.conditions import Conditions
from probe.runs.checks.calls import things_of
from probe.runs.jitter import is_same
from probe.runs.vary import changes_labels, with_places
from probe.tasks.reserved import difference
from probe.tasks.task import Task


def difference_under(conditions: Conditions, task: Task, packaged: Task) -> str | None:
    """In what a task isn't the packaged one under these conditions, as far as can be told at once.

    Whether its things lie, and its marks are, exactly where the conditions put them is for a replay
    to find out.
    """
    scene, known = task.scene, packaged.scene
    if things_of(scene) != things_of(known):
        return "other things are on its table"
    if conditions.pose_jitter:
        if not is_same(known, scene, conditions.pose_jitter):
            return "its things lie farther away than small moves take them"
        known = replace(known, objects=scene.objects)
    if conditions.table == "other":
        known = replace(known, table=scene.table)
    packaged = replace(packaged, scene=known)
    if changes_labels(conditions):
        if [(it.letter, it.instance) for it in task.marks] != [
            (it.letter, it.instance) for it in packaged.marks
        ]:
            return "its marks are on other things"
        asked = with_places(packaged.question, task.marks)
        packaged = replace(packaged, marks=task.marks, question=asked)
    return difference(task, packaged)
