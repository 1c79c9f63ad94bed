"""The teachers of `probe collect` at work: the scripted one, or a model in the seat."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import closing
from dataclasses import replace
from functools import partial
from pathlib import Path

from probe.api.resources import tables_for
from probe.cli.engines import EngineChoice
from probe.cli.model_run import ModelRunOptions, run_model
from probe.cli.teaching import WORKERS, TeachingSetup
from probe.engines.plan import Engine
from probe.episodes.noise import NOISES
from probe.generation.build_folder import BuildFolder
from probe.generation.making import TaskMaker, make_tasks
from probe.report.scene_renderer import SceneRenderer
from probe.runs.plan import RunOrder
from probe.runs.run import begun, work
from probe.tasks.suite import Suite
from probe.train.collect.batches import TASKS
from probe.train.collect.collecting import Play, TeacherWorkers
from probe.train.collect.teacher import TEACHER, TeacherWorker, teacher_for
from probe.transcripts.prompts import Setting
from probe.types import Shard

_ROUNDS = 3
"""How often episodes of a model that fail on our side are asked for."""


def hands_of(site: TeachingSetup, out: Path, where: EngineChoice) -> TeacherWorkers:
    """Who does the work in a folder, and where.

    Raises:
        BadData: A model is to teach from a cluster.
    """
    engine = where.engine(out, site.workers, usual=WORKERS)
    if site.model is not None:
        where.refuse_for_models()
    parts = BuildFolder(out / TASKS)
    seen = None if where.store else parts
    maker = TaskMaker(seen, site.training, tables_for(site.pool))
    things = site.training()
    return TeacherWorkers(
        make=partial(make_tasks, maker, parts, engine=engine),
        play=_scripted(site, engine) if site.model is None else _seated(site, site.model),
        library=things,
        scene_renderer=lambda suite: SceneRenderer(suite, lambda: things),
    )


def _scripted(site: TeachingSetup, engine: Engine) -> Play:
    order = RunOrder(TEACHER, 1, NOISES[site.noise], site.conditions, points=site.counting)

    def play(suite: Suite, setting: Setting, runs: int, out: Path) -> Iterable[str]:
        mine = replace(order, setting=setting, runs=runs)
        place = TeacherWorker(mine, site.training, teacher_for(site.counting))
        with begun(out, suite, mine) as beginning:
            jobs = beginning.jobs
            with closing(work(out, beginning, place, engine)) as results:
                for number, (job, fault) in enumerate(results, start=1):
                    doing = f"{number} of {len(jobs)} {setting} episodes"
                    yield f"{doing}; {job.task.id}: {fault}" if fault else doing

    return play


def _seated(site: TeachingSetup, model: str) -> Play:
    options = ModelRunOptions(
        library=site.training,
        model=model,
        setting="agentic",
        epochs=1,
        points=site.counting,
        graphs=site.graphs or "full",
        pointer="oracle",
        endpoint=site.endpoint,
        prices=site.prices,
        noise=NOISES[site.noise],
        conditions=site.conditions,
        shard=Shard(),
        workers=site.workers or WORKERS,
    )

    def play(suite: Suite, setting: Setting, runs: int, out: Path) -> Iterator[str]:
        asked, missing = replace(options, setting=setting, epochs=runs), len(suite.tasks) * runs
        for _ in range(_ROUNDS):
            yield f"{missing} episodes go to {model} ({setting})"
            missing = run_model(suite, asked, out, plain=True)
            if not missing:
                return

    return play
