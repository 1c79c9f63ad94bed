"""What lies on covers: which things, on which covers, and whether they stay there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.episodes.oracle_view import oracle_view
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.covers import can_top, cover_of
from probe.generation.generate import make
from probe.generation.movable import steps
from probe.generation.plan import plan_of
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.stage import Stage
from probe.generation.task_generator import generator_of
from probe.generation.toppings import TOPPED, is_topped, some_of, with_toppings
from probe.generation.twins import check_toppings
from probe.question_types.beneath.generator import select_beneath
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.task import Task
from probe.types import Pose
from probe.verification.check import CheckDepth, check
from probe.world.model import Post


def topped_plan():
    plan = plan_of("beneath", 0)
    return TOPPED.put(plan, value=True)


def test_only_the_newest_rules_put_things_on_covers():
    plan = topped_plan()
    assert is_topped(plan)
    assert not is_topped(replace(plan, rules=2))
    assert not is_topped(TOPPED.put(plan, value=False))


def test_half_of_the_tasks_of_a_type_are_planned_with_something_on_a_cover():
    for name in ("beneath", "count", "find", "nested", "decoys", "ranked", "relation"):
        assert TOPPED in generator_of(name).turns
        topped = [TOPPED.of(plan_of(name, episode)) for episode in range(20)]
        assert sum(topped) == 10


def test_what_lies_on_a_cover_takes_the_place_of_one_of_the_crowd(library: Library):
    rng = np.random.default_rng(3)
    plain = select_beneath(library, TOPPED.put(topped_plan(), value=False), rng)
    topped = with_toppings(library, plain, [0], rng)
    assert len(topped.specs) == len(plain.specs)
    ((topping, below),) = topped.toppings.items()
    assert below == topped.covering[0]
    assert topping == len(topped.specs)
    assert topping not in topped.crowd
    assert len(topped.crowd) == len(plain.crowd) - 1
    spec = topped.specs[topping - 1]
    assert can_top(spec, topped.covers[0])
    assert spec.name not in {it.name for it in plain.specs}


def test_balls_tall_things_and_large_ones_stay_off(library: Library):
    book = cover_of(library, "proc_red_book")
    assert book is not None
    spec = replace(library["proc_red_apple"], size=(0.06, 0.05, 0.02))
    assert can_top(spec, book)
    for size in ((0.06, 0.06, 0.06), (0.06, 0.05, 0.04), (0.10, 0.05, 0.02), (0.03, 0.03, 0.01)):
        assert not can_top(replace(spec, size=size), book)


def test_one_or_more_of_the_covers_bear_something():
    drawn = [some_of(3, np.random.default_rng(seed)) for seed in range(60)]
    assert {len(some) for some in drawn} == {1, 2, 3}
    assert all(len(set(some)) == len(some) and set(some) <= {0, 1, 2} for some in drawn)


LIME, BOOK, BAR = 1, 2, 3


@pytest.fixture(scope="module")
def stage(library: Library) -> Stage:
    ids = ("proc_lime", "proc_red_book", "proc_pink_soap")
    return Stage([library[id] for id in ids], library, [Post(0.0, 0.0, 0.08)], UR5_TABLE)


def test_a_thing_lies_on_what_it_was_laid_on_and_nowhere_else(stage: Stage, library: Library):
    book, bar = library["proc_red_book"].size, library["proc_pink_soap"].size
    on = Pose((0.0, 0.0, book[2]))
    beside = Pose((book[0] / 2 + bar[0], 0.0, book[2]))
    beneath = Pose((0.0, 0.0, -book[2]))
    for pose, lies in ((on, True), (beside, False), (beneath, False)):
        assert stage.lies_on(BAR, BOOK, {BOOK: Pose(), BAR: pose}) is lies
    check_toppings({BAR: BOOK}, stage, {BOOK: Pose(), BAR: on})
    with pytest.raises(Rejected) as refused:
        check_toppings({BAR: BOOK}, stage, {BOOK: Pose(), BAR: beside})
    assert refused.value.rejection.check == "topping"


def test_physics_keeps_it_on_a_held_cover_and_on_a_free_one(stage: Stage):
    held = stage.heap({BOOK: Pose()}, [], np.random.default_rng(0))
    topped = stage.top({BAR: BOOK}, np.random.default_rng(0))
    assert topped[BOOK].position == pytest.approx(held[BOOK].position, abs=1e-3)
    assert stage.lies_on(BAR, BOOK, stage.settle(topped))


@pytest.fixture(scope="module")
def made(library: Library, renderer: Renderer) -> Task:
    for episode in range(40):
        attempt = Attempt(TaskSlot("beneath", episode), 0)
        if is_topped(attempt.plan):
            found = make(attempt, library, renderer, table_ids(None))
            if isinstance(found, TaskCandidate):
                return found.task
    raise AssertionError("none of some 20 attempts came to anything")


@pytest.mark.slow
def test_what_lies_on_the_cover_goes_first_and_the_task_holds(
    made: Task, library: Library, renderer: Renderer
):
    load_scene(renderer, made.scene, library)
    (topping, before), (cover, after) = steps(made, renderer)
    assert cover == made.cover
    assert (tuple(before), tuple(after)) == ((), (topping,))
    assert made.scene[topping].pose.position[2] > 0
    found = check(made, library, renderer, CheckDepth(solve=False)).problems
    assert [it for some in found.values() for it in some] == []


@pytest.mark.slow
def test_what_lies_on_a_cover_is_no_excuse_for_what_else_hides(
    made: Task, library: Library, renderer: Renderer
):
    load_scene(renderer, made.scene, library)
    (topping, _), _ = steps(made, renderer)
    target = made.scene[made.targets[0]].pose
    beside = replace(target, position=(*target.position[:2], 0.0))
    fallen = replace(made, scene=moved(made.scene, topping, beside))
    found = check(fallen, library, renderer, CheckDepth(solve=False)).problems
    assert [it for some in found.values() for it in some] != []


def moved(scene: Scene, instance: int, pose: Pose) -> Scene:
    objects = (replace(it, pose=pose) if it.instance == instance else it for it in scene.objects)
    return replace(scene, objects=tuple(objects))


@pytest.mark.slow
def test_what_lies_on_the_cover_vanishes_with_it_from_the_oracles_picture(
    made: Task, library: Library, renderer: Renderer
):
    load_scene(renderer, made.scene, library)
    (topping, _), _ = steps(made, renderer)
    assert made.cover is not None
    shown = oracle_view(made, library, renderer)
    assert shown.removed == tuple(sorted({topping, made.cover}))
    older = oracle_view(replace(made, version=2), library, renderer)
    assert older.removed == (made.cover,)
