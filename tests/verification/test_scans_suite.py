"""The suite of scanned objects: poses and ids come with the package, meshes from elsewhere."""

from __future__ import annotations

from collections import Counter

import pytest

from probe.assets.library import Library, open_library
from probe.render.renderer import Renderer
from probe.tasks.suite import check_objects
from probe.tasks.suite_file import packaged_suite
from probe.verification.balance import balances
from probe.verification.check import CheckDepth, check

SCANS, V1 = packaged_suite("v1-scans"), packaged_suite("v1")
MADE = ("beneath", "count", "find", "size")
"""Too few of the 132 scans mislead as Compare plans, or are alike enough for Reduce."""

FIRST = [
    next(task for task in SCANS.tasks if task.question_type == question_type)
    for question_type in MADE
]


@pytest.fixture(scope="module")
def scans(assets, cache) -> Library:
    return open_library("scans", assets, cache)


def test_fifteen_of_each_type_that_scans_allow_on_other_tables_than_those_of_v1():
    assert Counter(task.question_type for task in SCANS.tasks) == dict.fromkeys(MADE, 15)
    assert not {task.seed for task in SCANS.tasks} & {task.seed for task in V1.tasks}
    assert not set(SCANS.objects) & set(V1.objects)


def test_letters_and_what_is_planned_balance():
    # Which letter shows more isn't planned: "smaller" turns it round.
    planned = [it for it in balances(SCANS.tasks) if it.of != "letter x larger area"]
    spreads = {
        (it.question_type, it.of): max(it.counts.values()) - min(it.counts.values())
        for it in planned
    }
    assert max(spreads.values()) <= 2, spreads


@pytest.mark.slow
def test_objects_are_those_it_was_made_of(scans: Library):
    check_objects(SCANS, scans)


@pytest.mark.slow
@pytest.mark.parametrize("task", FIRST, ids=lambda task: task.id)
def test_one_task_of_each_type_holds(scans: Library, renderer: Renderer, task):
    verdict = check(task, scans, renderer, CheckDepth(solve=False))
    assert {name: found for name, found in verdict.problems.items() if found} == {}
