"""The suite v2: what doesn't need a picture of all, and a few tasks whole."""

from __future__ import annotations

from collections import Counter

import pytest

from probe.assets.library import Library, open_library
from probe.assets.pools.division import parts_shown
from probe.assets.tables import table_ids
from probe.generation.build import BuildResources, fill, without_notes
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.generation.depth_cues import DepthLook
from probe.generation.necessary import is_answerable_at_sight as at_sight
from probe.generation.necessary import view_of
from probe.generation.repeats import roles_of
from probe.perception.dials import Dials
from probe.render.renderer import Renderer
from probe.scores.estimates import macro_chance
from probe.scores.marking import roster_of_tasks
from probe.scores.roster import chance_by_type, letter_guessed, naive_by_type
from probe.tasks.headline import HeadlineErrors
from probe.tasks.suite import check_objects, selection
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import QUESTION_TYPES
from probe.verification.balance import balances
from probe.verification.check import CheckDepth, check, rebuild_problem

V2 = packaged_suite("v2")
SOME = [next(task for task in V2.tasks if task.question_type == it) for it in ("exact", "ranked")]


@pytest.fixture(scope="module")
def evaluated(cache) -> Library:
    return open_library("evaluation", None, cache)


def test_v2_is_306_tasks_of_all_types_on_tables_of_their_own():
    assert Counter(task.question_type for task in V2.tasks) == {
        **dict.fromkeys(QUESTION_TYPES, 22),
        "compare": 20,
    }
    assert len(QUESTION_TYPES) == 14 and len({task.scene for task in V2.tasks}) == 306
    others = [task for name in ("v1", "v1.1", "behind") for task in packaged_suite(name).tasks]
    assert not {task.seed for task in V2.tasks} & {task.seed for task in others}
    assert all(50_000_000 <= task.seed < 50_022_000 for task in V2.tasks)


def test_all_its_objects_are_for_evaluation():
    assert V2.pool == "evaluation"
    assert parts_shown(V2.objects) == {"evaluation": 1295}
    shown = {placed.object_id for task in V2.tasks for placed in task.scene.objects}
    assert shown == set(V2.objects)


def test_it_states_its_headline_setting():
    dials = Dials(over=0.14, under=0.08, general=1.0)
    assert V2.headline == HeadlineErrors(grasp=0.018, push=0.0, dials=dials)


def test_guesses_and_looks_give_what_pages_say():
    """Of 14 types Exact and Memory have no chance; five of Compare's 20 tasks are at sight."""
    listed = roster_of_tasks(V2.tasks)
    assert macro_chance(chance_by_type(listed)) == pytest.approx((10 / 5 + 2 / 2) / 14)
    assert macro_chance(chance_by_type(listed, letter_guessed)) == pytest.approx(3.4 / 14)
    naive = naive_by_type(listed)
    assert naive["compare"] == pytest.approx(5 / 20 + 15 / 20 / 2)
    assert naive["size"] == pytest.approx(7 / 22 + 15 / 22 / 2)
    assert naive["count"] == pytest.approx(8 / 22 + 14 / 22 / 3)
    assert naive["find"] == pytest.approx(6 / 22 + 16 / 22 / 5)
    assert 0.275 < macro_chance(naive) < 0.285


def test_all_its_tasks_were_solved_and_state_what_is_necessary():
    assert all(without_notes(task) != task for task in V2.tasks)
    necessary = Counter(task.certificate.measures["necessary"] for task in V2.tasks)
    assert necessary == {0: 26, 1: 100, 2: 100, 3: 60, 4: 16, 5: 4}


def test_it_asks_about_no_two_things_twice():
    asked = Counter(roles_of(task) for task in V2.tasks)
    assert max(asked.values()) == 1


def test_letters_balance():
    spreads = {
        it.question_type: max(it.counts.values()) - min(it.counts.values())
        for it in balances(V2.tasks)
        if it.of == "letter"
    }
    # "smaller" turns Size's letters round; two places of Compare have no task.
    assert spreads.pop("size") == spreads.pop("compare") == 2
    assert max(spreads.values()) == 1


@pytest.mark.slow
def test_objects_of_some_tasks_are_those_that_v2_was_made_of(evaluated: Library):
    check_objects(selection(V2, V2.tasks[::50], "some"), evaluated)


@pytest.mark.slow
@pytest.mark.parametrize("task", SOME, ids=lambda task: task.id)
def test_some_tasks_hold_and_come_out_of_their_seeds_again(
    evaluated: Library, renderer: Renderer, task
):
    verdict = check(task, evaluated, renderer, CheckDepth(solve=False))
    assert {name: found for name, found in verdict.problems.items() if found} == {}
    assert rebuild_problem(task, evaluated, renderer, table_ids(None)) is None


@pytest.mark.slow
def test_covers_of_size_touch_the_table_or_neither_does(
    evaluated: Library, renderer: Renderer, tmp_path
):
    """Candidate 50014000 was a task of v2 before the covers' lowest points were compared."""
    task = next(it for it in V2.tasks if it.question_type == "size" and not at_sight(it))
    view = view_of(task, evaluated, renderer)
    labels = view.labels(task.scene)
    looks = [DepthLook.of(view, task.scene, labels, mark.instance) for mark in task.marks]
    assert abs(looks[0].cover_low - looks[1].cover_low) < 0.003
    resources = BuildResources(evaluated, table_ids(None), renderer, setup=task.setup)
    first = next(fill(TaskSlot("size", 50014), BuildFolder(tmp_path / "parts"), resources))
    assert (first.seed, first.check) == (50014000, "rims")
