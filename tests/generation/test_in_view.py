"""Tasks that need no manipulation, and those that do, told by what their certificates state."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.generate import make
from probe.generation.in_view import OPEN, OPEN_QUARTER, is_open
from probe.generation.look_alikes import look_alike
from probe.generation.plan import plan_of
from probe.generation.result import TaskCandidate
from probe.generation.task_plan import PlannedProperty
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.visibility import Visibility
from probe.tasks.task import QuestionType, Task
from probe.verification.check import CheckDepth, check

TABLES = ("oak_planks",)
SHARES: dict[QuestionType, PlannedProperty[bool]] = {
    "find": OPEN, "count": OPEN, "size": OPEN, "compare": OPEN_QUARTER,
}  # fmt: skip
OPENED = tuple(SHARES)


def opened(question_type: QuestionType, *, wanted: bool) -> Iterator[int]:
    """Episodes that are planned to lie open, or not to, and in which an option is right."""
    for episode in range(200):
        wished = plan_of(question_type, episode)
        if SHARES[question_type].of(wished) == wanted and wished.letter != "E":
            yield episode


def kept(
    question_type: QuestionType, library: Library, renderer: Renderer, *, wanted: bool
) -> Task:
    """The first task of such an episode whose answer looks like no other option."""
    for episode in opened(question_type, wanted=wanted):
        for number in range(3):
            made = make(
                Attempt(TaskSlot(question_type, episode), number), library, renderer, TABLES
            )
            if isinstance(made, TaskCandidate) and not look_alike(made.task, library, renderer):
                return made.task
    raise AssertionError


def seen(task: Task, library: Library, renderer: Renderer) -> dict[int, Visibility]:
    load_scene(renderer, task.scene, library)
    return dict(measure(renderer, task.scene))


@pytest.mark.slow
@pytest.mark.parametrize("question_type", OPENED)
def test_an_open_task_shows_all_that_decides_and_needs_nothing(
    library: Library, renderer: Renderer, question_type: QuestionType
):
    task = kept(question_type, library, renderer, wanted=True)
    shown = seen(task, library, renderer)
    assert task.targets or question_type == "count"
    assert all(shown[number].fraction >= 0.5 for number in task.targets)
    if question_type == "count":
        assert all(it.fraction >= 0.3 and it.visible_px >= 400 for it in shown.values())
    assert task.certificate.measures["necessary"] == 0
    verdict = check(task, library, renderer, CheckDepth(solve=False))
    assert {name: found for name, found in verdict.problems.items() if found} == {}


@pytest.mark.slow
@pytest.mark.parametrize("question_type", ["find", "count"])
def test_a_task_that_is_not_open_needs_removals(
    library: Library, renderer: Renderer, question_type: QuestionType
):
    task = kept(question_type, library, renderer, wanted=False)
    assert task.certificate.measures["necessary"] >= 1
    verdict = check(task, library, renderer, CheckDepth(solve=False))
    assert {name: found for name, found in verdict.problems.items() if found} == {}


@pytest.mark.parametrize(("question_type", "number"), [*zip(OPENED, (40, 40, 40, 30), strict=True)])
def test_a_part_of_the_plans_is_open_by_the_new_rules_alone(
    question_type: QuestionType, number: int
):
    newer, older = (
        [plan_of(question_type, e, rules=rules) for e in range(120)] for rules in (3, 2)
    )
    assert sum(is_open(it, SHARES[question_type]) for it in newer) == number
    assert not any(is_open(it, SHARES[question_type]) for it in older)
