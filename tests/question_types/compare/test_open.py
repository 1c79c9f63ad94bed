"""Frozen tasks of Compare by version 3 of the rules: one lies open, and one is hidden."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from probe.assets.library import Library
from probe.generation.necessary import NECESSARY
from probe.generation.twin_worlds import other_world
from probe.render.renderer import Renderer
from probe.tasks.suite import check_objects
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.types import Pose
from probe.verification.check import CheckDepth, check
from probe.verification.text import read_anew

SUITE = read_suite(Path(__file__).parent / "tasks.json")
OPEN, HIDDEN = SUITE.tasks


def problems(task: Task, library: Library, renderer: Renderer) -> Mapping[str, str]:
    """What is wrong, by check."""
    found = check(task, library, renderer, CheckDepth(solve=False)).problems
    return {name: "; ".join(some) for name, some in found.items() if some}


def stating(task: Task, name: str, value: float) -> Task:
    """It, with something else measured."""
    measures = {**task.certificate.measures, name: value}
    return replace(task, certificate=replace(task.certificate, measures=measures))


def covered(task: Task, number: int, by: int) -> Task:
    """It, with another thing right over one of them."""
    x, y, z = task.scene[number].pose.position
    over = Pose((x, y, z + 0.15), task.scene[by].pose.wxyz)
    objects = tuple(
        replace(it, pose=over) if it.instance == by else it for it in task.scene.objects
    )
    return replace(task, scene=replace(task.scene, objects=objects))


def largest(task: Task, library: Library) -> int:
    """The widest thing that the question has nothing to do with."""
    others = [
        it
        for it in task.scene.objects
        if it.instance not in task.targets and library[it.object_id].name != task.subject
    ]
    return max(others, key=lambda it: sorted(library[it.object_id].size)[1]).instance


def test_they_are_of_the_library_and_read_as_they_should(library: Library):
    check_objects(SUITE, library)
    assert [it for task in SUITE.tasks for it in read_anew(task, library)] == []
    assert [task.version for task in SUITE.tasks] == [3, 3]
    assert [task.certificate.measures[NECESSARY] > 0 for task in SUITE.tasks] == [False, True]


@pytest.mark.slow
def test_both_pass_all_checks(library: Library, renderer: Renderer):
    assert [problems(task, library, renderer) for task in SUITE.tasks] == [{}, {}]


@pytest.mark.slow
def test_an_open_task_may_not_be_called_hidden(library: Library, renderer: Renderer):
    found = problems(stating(OPEN, NECESSARY, 1), library, renderer)["hidden"]
    assert "it needs 0 removals, not 1" in found
    assert "A shows by" in found and "B shows by" in found


@pytest.mark.slow
def test_a_hidden_task_may_not_be_called_open(library: Library, renderer: Renderer):
    found = problems(stating(HIDDEN, NECESSARY, 0), library, renderer)["hidden"]
    stated = HIDDEN.certificate.measures[NECESSARY]
    assert f"it needs {stated:g} removals, not 0" in found
    assert "A shows by" in found and "B shows by" in found


@pytest.mark.slow
def test_what_is_marked_must_lie_open(library: Library, renderer: Renderer):
    hiding = covered(OPEN, OPEN.marks[0].instance, largest(OPEN, library))
    found = problems(hiding, library, renderer)["hidden"]
    assert "A shows by" in found and "it needs" in found


@pytest.mark.slow
def test_what_it_is_compared_with_must_lie_open(library: Library, renderer: Renderer):
    assert OPEN.form == "like"
    like = next(
        it.instance for it in OPEN.scene.objects if library[it.object_id].name == OPEN.subject
    )
    hiding = covered(OPEN, like, largest(OPEN, library))
    found = problems(hiding, library, renderer)["hidden"]
    assert f"of the {OPEN.subject} show" in found


@pytest.mark.slow
def test_the_paint_that_lies_open_must_be_the_one_that_is_right(
    library: Library, renderer: Renderer
):
    twins = OPEN.certificate.candidates[2:]
    marked = [mark.instance for mark in OPEN.marks]
    painted = other_world(OPEN.scene, dict(zip(marked, twins, strict=True)))
    proof = replace(OPEN.certificate, candidates=(*twins, *OPEN.certificate.candidates[:2]))
    found = problems(replace(OPEN, scene=painted, certificate=proof), library, renderer)
    assert "the other one fits" in found["hidden"] and "text" in found
