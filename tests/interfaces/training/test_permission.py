"""No task that models are evaluated on is trained on, unless somebody says so."""

from __future__ import annotations

from dataclasses import replace

import pytest

from interfaces.training.painted_tables import TASKS
from probe.assets.pools.division import divided
from probe.interfaces.training.permission import NotForTraining, check_for_training
from probe.tasks.suite import Suite
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task

EVALUATED = next(row.id for row in divided().values() if row.part == "evaluation")


def suite(*tasks: Task) -> Suite:
    return Suite("practice", tasks, {})


def of_things(task: Task, name: str) -> Task:
    first, *others = task.scene.objects
    things = (replace(first, object_id=name), *others)
    return replace(task, scene=replace(task.scene, objects=things))


def test_tasks_for_training_are_taken():
    check_for_training(suite(*TASKS))


@pytest.mark.parametrize("name", ["v1", "v1.1", "behind"])
def test_suites_of_the_package_are_refused(name):
    with pytest.raises(NotForTraining, match=rf"{name}: .* is no task to train on \(task: "):
        check_for_training(packaged_suite(name))


@pytest.mark.parametrize(
    ("changed", "why"),
    [
        (replace(TASKS[0], seed=1_000_000_000), "seed: 1000000000 is below 2000000000"),
        (replace(TASKS[0], scene=packaged_suite("v1").tasks[3].scene), "scene: v1, "),
        (of_things(TASKS[0], EVALUATED), f"object: {EVALUATED}"),
        (of_things(TASKS[0], "somebodys_cup"), "unsplit object: somebodys_cup"),
    ],
    ids=["seed", "scene", "object", "unknown object"],
)
def test_what_belongs_to_evaluation_is_refused(changed, why):
    with pytest.raises(NotForTraining, match=rf"{changed.id} is no task to train on \({why}"):
        check_for_training(suite(*TASKS[1:], changed))
