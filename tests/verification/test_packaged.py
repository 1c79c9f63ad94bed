"""The suites of the package: what doesn't need a picture of all, and one task a type of all."""

from __future__ import annotations

from collections import Counter

import pytest

from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.generation.build import without_notes
from probe.render.renderer import Renderer
from probe.tasks.suite import check_objects, selection
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task
from probe.verification.balance import balances
from probe.verification.check import CheckDepth, check, rebuild_problem

V1, UNFILTERED = packaged_suite("v1"), packaged_suite("v1-unfiltered")
V1_1 = packaged_suite("v1.1")


def quickly_solved(question_type: str) -> Task:
    """The first of a type that the very first attempt solved, by grasps: others take minutes."""
    first = {"solved_attempt": 0.0, "solved_by_pushing_first": 0.0}
    return next(
        task
        for task in V1.tasks
        if task.question_type == question_type
        and first.items() <= task.certificate.measures.items()
    )


FIRST = [quickly_solved(name) for name in dict.fromkeys(task.question_type for task in V1.tasks)]


def test_v1_is_150_tasks_of_six_types_on_tables_of_their_own():
    assert Counter(task.question_type for task in V1.tasks) == {
        "beneath": 26, "compare": 24, "count": 21, "find": 28, "reduce": 23, "size": 28,
    }  # fmt: skip
    assert len({task.scene for task in V1.tasks}) == 150
    seeds = [task.seed for task in (*V1.tasks, *UNFILTERED.tasks)]
    assert all(1_000_000 <= seed < 2_000_000 for seed in seeds)


def test_v1_1_is_v1_but_for_seven_reduce_tasks():
    mine, before = ({task.id: task for task in suite.tasks} for suite in (V1_1, V1))
    assert Counter(task.question_type for task in mine.values()) == Counter(
        task.question_type for task in before.values()
    )
    kept = mine.keys() & before.keys()
    assert len(kept) == 143 and all(mine[name] == before[name] for name in kept)
    others = [task for name, task in mine.items() if name not in before]
    assert {task.question_type for task in others} == {"reduce"}
    assert all(1_000_000 <= task.seed < 2_000_000 for task in others)
    assert len({task.scene for task in mine.values()}) == 150


def test_unfiltered_tasks_are_others_and_none_was_solved():
    kept = {task.scene for task in V1.tasks}
    assert len(UNFILTERED.tasks) == 12
    assert all(task.scene not in kept for task in UNFILTERED.tasks)
    assert all(without_notes(task) == task for task in UNFILTERED.tasks)
    assert all(without_notes(task) != task for task in V1.tasks)


def test_letters_and_crossings_of_v1_balance():
    found = list(balances(V1.tasks))
    assert [b for b in found if b.of == "letter" and not b.even] == []
    # 28 are three and a half rounds of Size's crossings, and "smaller" turns letters round.
    assert [b for b in balances(V1_1.tasks) if b.of == "letter" and not b.even] == []
    spreads = {
        (b.question_type, b.of): max(b.counts.values()) - min(b.counts.values()) for b in found
    }
    assert len(spreads) == 11 and max(spreads.values()) <= 2
    assert [name for name, spread in spreads.items() if spread > 1] == [
        ("size", "letter x larger area"),
        ("size", "what shows of the larger"),
    ]


@pytest.mark.slow
@pytest.mark.every_object
def test_objects_are_those_that_v1_was_made_of(library: Library):
    check_objects(V1, library)
    check_objects(UNFILTERED, library)


@pytest.mark.slow
def test_objects_of_some_tasks_are_those_that_v1_was_made_of(library: Library):
    check_objects(selection(V1, V1.tasks[::25], "some"), library)


@pytest.mark.slow
@pytest.mark.parametrize("task", FIRST, ids=lambda task: task.id)
def test_one_task_of_each_type_holds(library: Library, renderer: Renderer, task):
    """That the scripted agent acts as it did is what tests/golden shows, for a task of each."""
    solve = task.question_type == "beneath"
    verdict = check(task, library, renderer, CheckDepth(solve=solve))
    assert {name: found for name, found in verdict.problems.items() if found} == {}
    assert verdict.solved == solve


@pytest.mark.slow
@pytest.mark.parametrize("task", FIRST, ids=lambda task: task.id)
def test_one_task_of_each_type_comes_out_of_its_seed_again(
    library: Library, renderer: Renderer, task
):
    assert rebuild_problem(task, library, renderer, table_ids(None)) is None
