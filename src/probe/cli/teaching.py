"""Who teaches and with what, for `probe collect`: the scripted teacher, or a model in the seat."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from probe.assets.library import open_library
from probe.bench.models import settings_of
from probe.certify.parts import Parts
from probe.chat.prompts import Arm
from probe.cli.seats import Seats, take_seats
from probe.cli.surroundings import (
    Pool,
    assets_folder,
    cache_folder,
    library_folder,
    tables_for,
)
from probe.episodes.conditions import Conditions, LightKind
from probe.episodes.luck import NOISES, NoiseName
from probe.episodes.seat import Points
from probe.report.darkroom import Darkroom
from probe.runs.plan import Order, Shard
from probe.runs.run import begun, work
from probe.tasks.suite import Suite
from probe.train.batches import TASKS
from probe.train.collecting import Hands, Play
from probe.train.making import Studio, Training, make_tasks
from probe.train.settings import Settings
from probe.train.teacher import TEACHER, Classroom, teacher_for


@dataclass(frozen=True)
class Site:
    """Who teaches, with which objects, and under which conditions.

    Attributes:
        model: A model that teaches, by a name of docs/models.md or the harness's own; by default
            the scripted teacher, which gives its reasons in words.
        endpoint: Address of a server that speaks OpenAI's protocol.
        prices: A file that says what tokens cost.
        points: How places are counted; by default as suits the model, or in pixels.
        pool: Which objects appear.
        split: Take the training part of this split alone (`probe assets split`).
        noise: How far the hand errs.
        lighting: Of the pictures.
        workers: Processes.
    """

    model: str | None = None
    endpoint: str | None = None
    prices: Path | None = None
    points: Points | None = None
    pool: Pool = "procedural"
    split: Path | None = None
    noise: NoiseName = "none"
    lighting: LightKind = "ambient"
    workers: int = 2

    @property
    def counting(self) -> Points:
        """How places are counted."""
        return self.points or (settings_of(self.model).points if self.model else "pixels")

    @property
    def training(self) -> Training:
        """Opens the objects."""
        opened = partial(open_library, self.pool, assets_folder(), cache_folder(), library_folder())
        return Training(opened, self.split)

    @property
    def settings(self) -> Settings:
        """What must stay the same in a folder."""
        mark = None
        if self.split is not None:
            # Opening it says what is wrong with it, if something is.
            self.training()
            mark = hashlib.sha256(self.split.read_bytes()).hexdigest()[:16]
        return Settings(
            agent=self.model or TEACHER,
            pool=self.pool,
            split=mark,
            points=self.counting,
            noise=self.noise,
            lighting=self.lighting,
        )

    @property
    def conditions(self) -> Conditions:
        """In what episodes differ from tasks."""
        return Conditions(lighting=self.lighting)

    def hands(self, out: Path) -> Hands:
        """Who does the work in a folder."""
        studio = Studio(
            Parts(out / TASKS), self.training, tables_for(self.pool), cache_folder() / "light"
        )
        things = self.training()
        return Hands(
            make=partial(make_tasks, studio, workers=self.workers),
            play=self._taught() if self.model is None else self._seated(self.model),
            library=things,
            darkroom=lambda suite: Darkroom(suite, lambda: things, assets_folder()),
        )

    def _taught(self) -> Play:
        """The scripted teacher plays."""
        order = Order(TEACHER, 1, NOISES[self.noise], self.conditions, points=self.counting)

        def play(suite: Suite, arm: Arm, runs: int, out: Path) -> Iterable[str]:
            mine = replace(order, arm=arm, runs=runs)
            place = Classroom(
                mine, self.training, teacher_for(self.counting), cache_folder() / "light"
            )
            with begun(out, suite, mine) as beginning:
                jobs = beginning.jobs
                with closing(work(out, jobs, place, self.workers)) as results:
                    for number, (job, fault) in enumerate(results, start=1):
                        doing = f"{number} of {len(jobs)} {arm} episodes"
                        yield f"{doing}; {job.task.id}: {fault}" if fault else doing

        return play

    def _seated(self, model: str) -> Play:
        """A model plays, through the harness."""
        seats = Seats(
            model,
            "agentic",
            1,
            self.counting,
            "oracle",
            self.endpoint,
            self.prices,
            NOISES[self.noise],
            self.conditions,
            Shard(),
            self.workers,
        )

        def play(suite: Suite, arm: Arm, runs: int, out: Path) -> Iterator[str]:
            yield f"{len(suite.tasks)} tasks go to {model} ({arm})"
            take_seats(suite, replace(seats, arm=arm, epochs=runs), out, dry_run=False)

        return play
