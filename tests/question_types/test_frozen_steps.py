"""Frozen tasks of the types with several steps, kept beside their tests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from probe.agents.scripted import Scripted
from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.episodes.circumstances import Circumstances
from probe.episodes.noise import NO_NOISE, NOISES, Noise
from probe.episodes.oracle_view import oracle_view, vanishing
from probe.episodes.play import play, score
from probe.generation.movable import steps
from probe.generation.necessary import NECESSARY, necessary_removals
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.suite import Suite, check_objects
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Option, Task
from probe.types import Pose
from probe.verification.check import CheckDepth, check, rebuild_problem
from probe.verification.text import read_anew

HERE = Path(__file__).parent
TYPES = ("nested", "exact", "decoys", "ranked", "budgeted", "relation", "memory")


def suite(question_type: str) -> Suite:
    return read_suite(HERE / question_type / "tasks.json")


TASKS: Mapping[str, Task] = {name: suite(name).tasks[0] for name in TYPES}


def other_than(task: Task) -> int:
    """Something on a task's table that its question has nothing to do with."""
    known = {*task.targets, *task.named, task.cover}
    return next(it.instance for it in task.scene.objects if it.instance not in known)


def problems(task: Task, library: Library, renderer: Renderer) -> str:
    found = check(task, library, renderer, CheckDepth(solve=False)).problems
    return "; ".join(problem for some in found.values() for problem in some)


@pytest.mark.parametrize("name", TYPES)
def test_they_are_made_of_the_librarys_objects_and_read_as_they_should(library: Library, name: str):
    check_objects(suite(name), library)
    assert [it for task in suite(name).tasks for it in read_anew(task, library)] == []


@pytest.mark.parametrize("name", TYPES)
def test_what_they_ask_is_checked_against_the_table(library: Library, name: str):
    task = TASKS[name]
    assert task.cover is not None or task.named
    other = other_than(task)
    wrong = replace(task, named=(other,)) if task.named else replace(task, cover=other)
    assert any("its subject is" in it for it in read_anew(wrong, library))
    renamed = replace(task, question=task.question.replace(task.subject.split(", ")[0], "giraffe"))
    if renamed.question != task.question:
        assert any("it asks" in it for it in read_anew(renamed, library))
    option = replace(task, options=(Option("A", "giraffe"), *task.options[1:]))
    assert any("giraffe" in it for it in read_anew(option, library))
    letter = next(it.letter for it in task.options if it.letter != task.answer)
    assert any("is true" in it for it in read_anew(replace(task, answer=letter), library))
    measures = {k: v for k, v in task.certificate.measures.items() if k != NECESSARY}
    unstated = replace(task, certificate=replace(task.certificate, measures=measures))
    assert read_anew(unstated, library) == (f"its certificate doesn't state {NECESSARY}",)


@pytest.mark.parametrize("name", ["nested", "exact", "decoys", "relation", "memory"])
def test_candidates_of_unlike_height_are_refused(library: Library, name: str):
    task = TASKS[name]
    tall = max(library.specs, key=lambda it: it.size[2]).id
    drawn = tuple(
        it if it == task.scene[task.targets[0]].object_id else tall
        for it in task.certificate.candidates
    )
    wrong = replace(task, certificate=replace(task.certificate, candidates=drawn))
    assert any("a side of its candidates" in it for it in read_anew(wrong, library))


@pytest.mark.slow
@pytest.mark.parametrize("name", TYPES)
def test_they_pass_all_checks_and_a_wrong_number_of_removals_does_not(
    library: Library, renderer: Renderer, name: str
):
    task = TASKS[name]
    assert problems(task, library, renderer) == ""
    stated = task.certificate.measures[NECESSARY]
    measures = {**task.certificate.measures, NECESSARY: stated + 1}
    wrong = replace(task, certificate=replace(task.certificate, measures=measures))
    told = f"it needs {stated:g} removals, not {stated + 1:g}"
    assert told in problems(wrong, library, renderer)


@pytest.mark.slow
@pytest.mark.parametrize("name", TYPES)
def test_a_task_that_hides_nothing_fails(library: Library, renderer: Renderer, name: str):
    task = TASKS[name]
    load_scene(renderer, task.scene, library)
    uncovered = sorted(vanishing(task, renderer))
    aside = {number: (0.19, 0.19 - 0.12 * place) for place, number in enumerate(uncovered)}
    scene = replace(
        task.scene,
        objects=tuple(
            replace(it, pose=Pose((*aside[it.instance], 0.3), it.pose.wxyz))
            if it.instance in aside
            else it
            for it in task.scene.objects
        ),
    )
    assert "Exactly one" in (told := problems(replace(task, scene=scene), library, renderer)) or (
        "shows by" in told
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", TYPES)
def test_the_oracle_view_takes_away_all_that_is_necessary(
    library: Library, renderer: Renderer, name: str
):
    for task in suite(name).tasks:
        gone = set(oracle_view(task, library, renderer).removed)
        needed = necessary_removals(task, library, renderer)
        assert needed is not None and set(needed) <= gone and not gone & set(task.targets)
        assert len(needed) == task.certificate.measures[NECESSARY]


@pytest.mark.slow
def test_the_inner_cover_has_to_be_movable_too(library: Library, renderer: Renderer):
    task = TASKS["nested"]
    load_scene(renderer, task.scene, library)
    (outer, before), (inner, after) = steps(task, renderer)
    assert (outer, tuple(before)) == (task.cover, ())
    assert {outer, inner} == set(necessary_removals(task, library, renderer) or ())
    assert tuple(after) == (outer,)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["nested", "exact", "decoys", "ranked", "relation", "memory"])
def test_a_task_comes_out_of_its_seed_again(library: Library, renderer: Renderer, name: str):
    assert rebuild_problem(TASKS[name], library, renderer, table_ids(None)) is None


def solved(name: str, noise: Noise, library: Library, renderer: Renderer) -> list[bool]:
    fresh = Circumstances(run=90, noise=noise)
    found = list[bool]()
    for task in suite(name).tasks:
        agent = Scripted(name, task.subject, generator(task.seed, "fresh"), form=task.form)
        record = play(task, agent, "scripted", library, renderer, fresh)
        found.append(score(task, record, renderer).correct)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", TYPES)
def test_the_scripted_agent_solves_them_with_fresh_luck(
    library: Library, renderer: Renderer, name: str
):
    assert all(solved(name, NO_NOISE, library, renderer))


@pytest.mark.slow
def test_with_a_hand_that_errs_it_solves_all_but_one(library: Library, renderer: Renderer):
    """Of the other types there is one task."""
    found = solved("nested", NOISES["paper"], library, renderer)
    assert len(found) > 1 and sum(found) >= len(found) - 1
