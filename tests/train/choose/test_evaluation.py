"""What belongs to evaluation is found out, however it got into training."""

from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import FIRST_SEED, moved_away, suite_of, training_task
from probe.assets.pools.split import Split
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.salt import Salt
from probe.tasks.suite_file import packaged_suite, packaged_suites
from probe.tasks.task import Certificate
from probe.train.choose.evaluation import evaluation_of
from run_folders import DEMO
from task_examples import FIND

TASK = training_task(1)
IDS = [placed.object_id for placed in TASK.scene.objects]
SEEDED = replace(FIND, seed=FIRST_SEED + 7)
"""A suite whose base seed is a training seed, as a secret one may have."""


def as_for_training(task):
    """A suite's task under another name, with a training seed."""
    return replace(task, id="find-00000001", seed=FIRST_SEED + 1)


def test_a_training_task_may_be_learnt_from():
    assert evaluation_of([DEMO]).refusal(TASK) is None


@pytest.mark.parametrize("name", packaged_suites())
def test_each_task_of_a_packaged_suite_is_refused(name):
    suite = packaged_suite(name)
    evaluation = evaluation_of([suite])
    found = [evaluation.refusal(task) for task in suite.tasks]
    assert {it.leak for it in found if it} == {"task"} and None not in found


def test_a_seed_of_a_suite_is_refused_whatever_the_table():
    evaluation = evaluation_of([suite_of([SEEDED], "secret")])
    refusal = evaluation.refusal(replace(TASK, seed=SEEDED.seed))
    assert refusal and refusal.leak == "seed" and "secret" in refusal.detail


def test_a_seed_below_those_for_training_is_refused():
    refusal = evaluation_of([]).refusal(replace(TASK, seed=FIRST_SEED - 1))
    assert refusal and refusal.leak == "seed" and "1999999999 is below 2000000000" in refusal.detail


def test_a_private_suites_seed_is_refused_though_nobody_knows_the_suite():
    seed = Attempt(TaskSlot("find", 0), 0, Salt(bytes(32))).bears
    refusal = evaluation_of([]).refusal(replace(TASK, seed=seed))
    assert refusal and refusal.leak == "seed" and "is of a private suite" in refusal.detail


@pytest.mark.parametrize("change", [as_for_training, lambda it: moved_away(as_for_training(it))])
def test_a_suites_scene_under_another_seed_is_refused(change):
    task = DEMO.tasks[0]
    refusal = evaluation_of([DEMO]).refusal(change(task))
    assert refusal and refusal.leak == "scene" and task.id in refusal.detail


def with_ids(*ids: str):
    placed = tuple(
        replace(it, object_id=id) for it, id in zip(TASK.scene.objects, ids, strict=True)
    )
    return replace(TASK, scene=replace(TASK.scene, objects=placed))


def test_two_of_three_things_in_common_are_a_near_duplicate_one_is_not():
    evaluation = evaluation_of([suite_of([replace(TASK, id="s", seed=1)], "other")])
    near = evaluation.refusal(with_ids(IDS[0], "new_1", IDS[2]))
    assert near and near.leak == "scene"
    assert evaluation.refusal(with_ids(IDS[0], "new_1", "new_2")) is None


def test_near_duplicate_objects_count_as_the_same_in_a_scene():
    suite = suite_of([replace(TASK, id="s", seed=1)], "other")
    alike = with_ids("twin_0", "twin_1", "new")
    assert evaluation_of([suite]).refusal(alike) is None
    groups = [[IDS[0], "twin_0"], [IDS[1], "twin_1"]]
    refusal = evaluation_of([suite], groups=groups).refusal(alike)
    assert refusal and refusal.leak == "scene"


PARTS = {"a": "evaluation", **dict.fromkeys(IDS, "train"), "plum": "train"}


def test_an_object_for_evaluation_is_refused_on_the_table_and_among_the_options():
    evaluation = evaluation_of([], Split.model_validate({"parts": PARTS}))
    offered = replace(TASK, certificate=Certificate({}, {}, ("plum",)))
    assert evaluation.refusal(offered) is None
    shown = evaluation.refusal(
        replace(with_ids(IDS[0], IDS[1], "a"), certificate=offered.certificate)
    )
    named = evaluation.refusal(replace(TASK, certificate=Certificate({}, {}, ("plum", "a"))))
    assert shown and (shown.leak, shown.detail) == ("object", "a")
    assert named and (named.leak, named.detail) == ("object", "a")


def test_the_like_of_an_object_for_evaluation_is_refused_and_so_is_an_unknown_one():
    split = Split.model_validate({"parts": PARTS})
    plain = replace(TASK, certificate=Certificate({}, {}, ()))
    alike = evaluation_of([], split, [["a", IDS[2]]]).refusal(plain)
    assert alike and (alike.leak, alike.detail) == ("object", IDS[2])
    unknown = replace(with_ids(IDS[0], "b", IDS[2]), certificate=plain.certificate)
    refusal = evaluation_of([], split).refusal(unknown)
    assert refusal and (refusal.leak, refusal.detail) == ("unsplit object", "b")
