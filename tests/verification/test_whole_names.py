"""No candidate of a task by rules 3 may be what another one's name says in part."""

from __future__ import annotations

from dataclasses import replace

from probe.assets.library import Library
from probe.render.renderer import Renderer
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task
from probe.verification.remeasure import Remeasurement
from probe.verification.truth import clarity_problems

TASKS = [it for it in packaged_suite("v1").tasks if it.question_type == "reduce"]


def said(task: Task, library: Library, renderer: Renderer) -> list[str]:
    anew = Remeasurement(task.scene, library, renderer, task.camera)
    return [it for it in clarity_problems(task, anew) if "said of one thing" in it]


def test_tasks_of_v1_are_found_by_the_new_rules_alone(library: Library, renderer: Renderer):
    """`v1` offers "tea light" beside "red tea light"; also where it isn't offered but is there."""
    assert not any(said(task, library, renderer) for task in TASKS)
    found = [task for task in TASKS if said(replace(task, version=3), library, renderer)]
    assert 3 <= len(found) < len(TASKS)
    # One of its two such names isn't offered: "none of the above" could stand for it.
    assert "reduce-d199305e" in [task.id for task in found]
    names = {object_id: library[object_id].name for object_id in found[0].certificate.candidates}
    told = said(replace(found[0], version=3), library, renderer)
    assert all(sum(name in line for name in names.values()) >= 2 for line in told)
