"""The packaged suite of Behind."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest

from probe.agents.scripted import Scripted
from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.episodes.circumstances import Circumstances
from probe.episodes.noise import NOISES
from probe.episodes.oracle_view import oracle_view
from probe.episodes.play import play, score
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.suite import check_objects
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import LETTERS
from probe.verification.balance import balances
from probe.verification.check import CheckDepth, check, rebuild_problem
from probe.verification.text import read_anew

SUITE = packaged_suite("behind")
FIRST = SUITE.tasks[0]


def test_it_has_26_tasks_of_one_type_seen_from_the_front():
    assert len(SUITE.tasks) == 26
    assert {(task.question_type, task.camera) for task in SUITE.tasks} == {("behind", "front")}
    letters = Counter(task.answer for task in SUITE.tasks)
    assert set(letters) == set(LETTERS) and max(letters.values()) - min(letters.values()) <= 1
    assert all(balance.even for balance in balances(SUITE.tasks))


@pytest.mark.slow
def test_it_is_made_of_the_librarys_objects_and_reads_as_it_should(library: Library):
    check_objects(SUITE, library)
    assert [problem for task in SUITE.tasks for problem in read_anew(task, library)] == []


def test_what_it_asks_is_checked_against_the_table(library: Library):
    other = next(
        it.instance
        for it in FIRST.scene.objects
        if it.instance not in (FIRST.cover, *FIRST.targets)
    )
    assert any("its subject is" in it for it in read_anew(replace(FIRST, cover=other), library))
    same = replace(FIRST, cover=FIRST.targets[0])
    assert any("are the same" in it for it in read_anew(same, library))
    assert any("top camera" in it for it in read_anew(replace(FIRST, camera="top"), library))
    assert read_anew(replace(FIRST, cover=None), library) == (
        "what it names isn't what behind names",
    )


@pytest.mark.slow
@pytest.mark.parametrize("task", [FIRST, SUITE.tasks[13]], ids=lambda task: task.id)
def test_its_tasks_pass_all_checks(library: Library, renderer: Renderer, task):
    assert not any(check(task, library, renderer, CheckDepth(solve=False)).problems.values())


@pytest.mark.slow
def test_a_task_that_hides_nothing_fails(library: Library, renderer: Renderer):
    assert FIRST.cover is not None
    moved = replace(FIRST.scene[FIRST.cover], pose=FIRST.scene[FIRST.cover].pose)
    x, y, z = moved.pose.position
    moved = replace(moved, pose=replace(moved.pose, position=(x - 0.2, y, z)))
    others = [it for it in FIRST.scene.objects if it.instance != FIRST.cover]
    scene = replace(
        FIRST.scene, objects=tuple(sorted([*others, moved], key=lambda it: it.instance))
    )
    verdict = check(replace(FIRST, scene=scene), library, renderer, CheckDepth(solve=False))
    assert any("the answer shows by" in it for it in verdict.problems["hidden"])
    assert any("Exactly one candidate" in it for it in verdict.problems["invariant"])


@pytest.mark.slow
def test_a_task_comes_out_of_its_seed_again(library: Library, renderer: Renderer):
    assert rebuild_problem(FIRST, library, renderer, table_ids(None)) is None


@pytest.mark.slow
def test_the_oracle_view_takes_away_what_is_in_front(library: Library, renderer: Renderer):
    shown = oracle_view(FIRST, library, renderer)
    assert shown.removed == (FIRST.cover,)


@pytest.mark.slow
def test_the_scripted_agent_solves_most_with_fresh_luck(library: Library, renderer: Renderer):
    solved, fresh = 0, Circumstances(run=90, noise=NOISES["paper"])
    for task in SUITE.tasks[:5]:
        agent = Scripted("behind", task.subject, generator(task.seed, "fresh"))
        record = play(task, agent, "scripted", library, renderer, fresh)
        solved += score(task, record, renderer).correct
    assert solved >= 4
