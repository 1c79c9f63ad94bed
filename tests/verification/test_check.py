"""Frozen tasks pass; the same tasks with something wrong don't, and the right check says so."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.assets.library import Library
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.tasks.suite_file import demo_suite, packaged_suite
from probe.tasks.task import Option, Task
from probe.types import Pose
from probe.verification.check import CheckDepth, check

pytestmark = pytest.mark.slow
LOOK_ONLY = CheckDepth(solve=False)
DEMO = demo_suite()
MARKED = [task for task in packaged_suite("v1").tasks if task.marks]
COMPARE = next(task for task in MARKED if task.form == "colour")
SIZE = next(task for task in MARKED if task.form == "larger")


def demo(question_type: str, *, cover: bool = False) -> Task:
    """A demo task with a named answer."""
    return next(
        t for t in DEMO.tasks if t.question_type == question_type and (t.answer != "E" or cover)
    )


def moved(scene: Scene, instance: int, dx: float = 0.0, dz: float = 0.0) -> Scene:
    """The scene with one thing elsewhere."""

    def put(pose: Pose) -> Pose:
        x, y, z = pose.position
        return Pose((x + dx, y, z + dz), pose.wxyz)

    return replace(
        scene,
        objects=tuple(
            replace(o, pose=put(o.pose)) if o.instance == instance else o for o in scene.objects
        ),
    )


def failed(task: Task, library: Library, renderer: Renderer) -> set[str]:
    verdict = check(task, library, renderer, LOOK_ONLY)
    return {name for name, problems in verdict.problems.items() if problems}


def shown(task: Task, library: Library, renderer: Renderer) -> str:
    """What is wrong with what shows of it."""
    return "; ".join(check(task, library, renderer, LOOK_ONLY).problems["hidden"])


def without_others(task: Task) -> Task:
    """It, with nothing but its targets on the table and in its certificate."""
    seen = task.certificate.visibility
    certificate = replace(task.certificate, visibility={n: seen[n] for n in task.targets})
    return replace(task, scene=task.scene.only(*task.targets), certificate=certificate)


@pytest.mark.parametrize("task", DEMO.tasks, ids=lambda task: task.id)
def test_frozen_tasks_pass(library, renderer, task):
    assert failed(task, library, renderer) == set()


def test_the_observer_sees_what_shows(library, renderer):
    # Three toy cars, none of them hidden; and a hidden thing, of which nothing shows.
    seen = {task.id: check(task, library, renderer, LOOK_ONLY).observed for task in DEMO.tasks[2:5]}
    assert seen == {"count-45dd8d10": True, "count-281ce473": False, "find-75977c33": False}


def test_a_cover_elsewhere_hides_nothing(library, renderer):
    task = demo("beneath", cover=True)
    assert task.cover is not None
    bare = replace(task, scene=moved(task.scene, task.cover, dx=1.0))
    verdict = check(bare, library, renderer, LOOK_ONLY)
    assert any("the answer shows by" in problem for problem in verdict.problems["hidden"])
    assert verdict.problems["invariant"] and not verdict.holds


@pytest.mark.parametrize(
    ("task", "problem"),
    [(COMPARE, "of what shows of A tells it from its twin"), (SIZE, "tells too much")],
    ids=["compare", "size"],
)
def test_marked_things_in_full_view_tell_too_much(library, renderer, task, problem):
    assert shown(task, library, renderer) == ""
    bare = shown(without_others(task), library, renderer)
    assert "A shows by" in bare and "B shows by" in bare and problem in bare


@pytest.mark.parametrize("task", [COMPARE, SIZE], ids=["compare", "size"])
def test_a_task_by_older_rules_cant_say_that_it_lies_open(library, renderer, task):
    bare = without_others(task)
    measures = {**bare.certificate.measures, "necessary": 0.0}
    stating = replace(bare, certificate=replace(bare.certificate, measures=measures))
    told = shown(stating, library, renderer)
    assert "A shows by" in told and "B shows by" in told


def test_patches_are_measured_anew(library, renderer):
    lead = COMPARE.certificate.measures["patch_lead"]
    stated = {**COMPARE.certificate.measures, "patch_lead": lead + 3}
    untrue = replace(COMPARE, certificate=replace(COMPARE.certificate, measures=stated))
    assert f"patch leads by {lead:.1f}, not {lead + 3:.1f}" in shown(untrue, library, renderer)


def test_what_floats_is_not_at_rest(library, renderer):
    task = demo("count")
    highest = max(task.scene.objects, key=lambda o: o.pose.position[2])
    floating = replace(task, scene=moved(task.scene, highest.instance, dz=0.05))
    assert "at rest" in failed(floating, library, renderer)


def test_a_wrong_letter_is_untrue(library, renderer):
    task = demo("find")
    other = "A" if task.answer != "A" else "B"
    assert failed(replace(task, answer=other), library, renderer) == {"text", "invariant"}


def test_one_thing_more_changes_the_count(library, renderer):
    task = demo("count")
    gone = replace(
        task,
        scene=task.scene.without(task.targets[0]),
        targets=task.targets[1:],
        certificate=replace(
            task.certificate,
            visibility={
                n: v for n, v in task.certificate.visibility.items() if n != task.targets[0]
            },
        ),
    )
    assert "invariant" in failed(gone, library, renderer)


def test_options_that_say_the_same_are_ambiguous(library, renderer):
    task = demo("find")
    wrong = [o.letter for o in task.options if o.letter not in (task.answer, "E")]
    text = next(o.text for o in task.options if o.letter == wrong[0])
    options = tuple(Option(o.letter, text) if o.letter == wrong[1] else o for o in task.options)
    assert failed(replace(task, options=options), library, renderer) == {"text", "unambiguous"}


def test_histories_leave_every_grade_as_it_was(library, renderer):
    task = demo("count")
    verdict = check(task, library, renderer, CheckDepth(solve=False, history=True))
    assert verdict.holds and verdict.histories == 3


@pytest.mark.parametrize(("noted", "rules"), [(True, 2), (False, 2), (True, 3)])
def test_what_an_older_hand_solved_holds_though_none_of_today_does(
    library, renderer, monkeypatch, noted, rules
):
    task = demo("beneath")
    monkeypatch.setattr("probe.verification.check.solves_as_noted", lambda *_: False)
    monkeypatch.setattr("probe.verification.check.trials", lambda *_: ())
    measures = {"necessary": 1.0}
    if noted:
        measures |= {"solved_attempt": 0.0, "solved_by_pushing_first": 0.0}
    task = replace(task, version=rules, certificate=replace(task.certificate, measures=measures))
    verdict = check(task, library, renderer, CheckDepth(solve=True))
    holds = noted and rules == 2
    assert verdict.outgrown is holds
    assert verdict.problems.get("solvable", ()) == (() if holds else ("none of 0 attempts",))
