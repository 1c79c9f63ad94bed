"""Tables for training whose processes have painted things, and no physics and no renderer."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from bench.painted import PaintedPlace
from lessons import training_task
from probe.assets.library import open_library
from probe.assets.pools.division import divided
from probe.episodes.participation import Points
from probe.interfaces.training.tables import TrainingTables
from probe.runs.plan import RunOrder
from probe.tasks.suite import Suite
from probe.tasks.task import Task

TRAINING = sorted(row.id for row in divided().values() if row.part == "train")


def allowed_task(number: int) -> Task:
    """A task whose things are built in, and for training."""
    task = training_task(number, "count")
    things = [
        replace(it, object_id=TRAINING[20 * number + place])
        for place, it in enumerate(task.scene.objects)
    ]
    return replace(task, scene=replace(task.scene, objects=tuple(things)))


TASKS = tuple(allowed_task(number) for number in range(1, 5))
ORDER = RunOrder("learner", setting="text-only, short graphs")


THINGS = {it.object_id: (1.0, 2.0) for task in TASKS for it in task.scene.objects}
PRACTICE = Suite("practice", TASKS, THINGS)


def painted_tables(
    folder: Path, suite: Suite = PRACTICE, points: Points = "pixels", **more: Any
) -> TrainingTables:
    """Tables at which a grasp kills the process as often as the file "deaths" says."""
    library = partial(open_library, "procedural", None, folder)
    order = replace(ORDER, points=points)
    return TrainingTables(suite, PaintedPlace(order, library, folder / "deaths"), **more)
