"""Painted tables in worker processes: everything of a model's seat but physics and drawing."""

from __future__ import annotations

import os
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from probe.assets.library import open_library
from probe.bench.plan import ModelRunPlan
from probe.episodes.episode import Episode
from probe.episodes.grading import answer_form, question_of
from probe.episodes.turns import Call
from probe.perception.oracle import Oracle
from probe.runs.episode_worker import EpisodeWorker, EpisodeWorkerSetup
from probe.runs.plan import Job
from probe.runs.worker_messages import StartEpisode
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.suite import Suite
from probe.tasks.suite_file import demo_suite
from probe.toolshed.toolshed import Toolshed
from probe.types import Array, Pose
from tabletops import Block, Obedient, PaintedStation, paint, spec

SPECS = {701: spec("red mug", "red"), 702: spec("white ball", "white")}
BLOCKS = (
    Block(701, (100, 100, 219, 219)),
    Block(702, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240)),
)


class Deadly(Obedient):
    """Kills its own process in a grasp, as often as a file says."""

    def __init__(self, deaths: Path) -> None:
        super().__init__()
        self._deaths = deaths

    def grasp_and_remove(self, station, frame, mask, drop_at):
        left = int(self._deaths.read_text()) if self._deaths.exists() else 0
        if left:
            self._deaths.write_text(str(left - 1))
            os._exit(9)
        return super().grasp_and_remove(station, frame, mask, drop_at)


class Told:
    """Tells the record of the task's own things: one is away for each painted one that is gone."""

    def __init__(self, station: PaintedStation, scene: Scene) -> None:
        self._station = station
        self._scene = scene

    def snapshot(self) -> Scene:
        gone = len(BLOCKS) - len(self._station.blocks)
        objects = self._scene.objects
        away = tuple(replace(it, pose=Pose((0.0, -0.5, 0.1))) for it in objects[:gone])
        return replace(self._scene, objects=(*away, *objects[gone:]))

    def joints(self) -> Array:
        return self._station.joints()


class PaintedKeeper(EpisodeWorker):
    """The same two things on every table; a record tells of the task's."""

    def _open(self, job: Job) -> Episode:
        station = PaintedStation(BLOCKS)
        skills = Deadly(Path(str(self._place.cache)))
        form = answer_form(job.task)
        tools = Toolshed(station, Oracle(SPECS), skills, UR5_TABLE, form=form)
        question = question_of(job.task, tools.first_picture())
        name = self._order.agent
        witness = Told(station, job.task.scene)
        return Episode(job.task.id, question, tools, witness, agent_name=name, run=job.run)

    def _stills(self, job: Job):
        count = {"blind": 0, "direct": 1, "oracle-view": 2}[self._setting]
        picture = paint(BLOCKS).rgb
        assert picture is not None
        return [picture] * count


@dataclass(frozen=True)
class PaintedPlace(EpisodeWorkerSetup):
    """A process with painted tables; its cache is the file that says how often it dies."""

    @contextmanager
    def __call__(self) -> Generator[Any]:
        things: Any = SimpleNamespace(assets=None)
        yield PaintedKeeper(self, things, None).do  # type: ignore[arg-type]


def shown(plan: ModelRunPlan, calls: Sequence[Call]) -> tuple[bytes, list[bytes | None]]:
    """What a table in this process shows: with the question, and after each call."""
    place = PaintedPlace(plan.order("m", ""), plan.library, plan.cache)
    with place() as do:
        (first,) = do(StartEpisode(Job(plan.tasks[0], 0))).pictures
        return first, [do(call).picture for call in calls]


def demo(count: int = 6) -> Suite:
    """The first tasks of the demo."""
    whole = demo_suite()
    tasks = whole.tasks[:count]
    ids = {placed.object_id for task in tasks for placed in task.scene.objects}
    return Suite("small", tasks, {id: mark for id, mark in whole.objects.items() if id in ids})


def plan(out: Path, setting: Any, suite: Suite, **more: Any) -> ModelRunPlan:
    """One run of each task, at two tables."""
    settings: dict[str, Any] = {"epochs": 1, "workers": 2, "cache": out / "deaths"} | more
    library = partial(open_library, "procedural", None, out / "cache")
    return ModelRunPlan(setting, suite, suite.tasks, out, library, **settings)
