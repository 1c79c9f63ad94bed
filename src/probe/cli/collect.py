"""`probe collect`: let a teacher work on training tasks until enough of them are answered."""

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
from probe.cli.bars import bar as progress_bar
from probe.cli.seats import Seats, take_seats
from probe.cli.shards import parse_shard
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
from probe.errors import BadData
from probe.report.darkroom import Darkroom
from probe.runs.plan import Order, Shard
from probe.runs.run import begun, work
from probe.tasks.suite import Suite
from probe.tasks.task import QuestionKind
from probe.train.aim import PAPER_COUNTS, Aim, Mode, in_proportion
from probe.train.batches import TASKS, Harvest
from probe.train.collecting import Hands, Play
from probe.train.collecting import collect as collected
from probe.train.making import FIRST_EPISODE, Studio, Training, make_tasks
from probe.train.settings import Settings, claim
from probe.train.teacher import TEACHER, Classroom, teacher_for

_PAPER = dict(PAPER_COUNTS)


def collect(
    out: Path = Path("outputs/collected"),
    counts: dict[QuestionKind, int] = _PAPER,
    total: int | None = None,
    model: str | None = None,
    arms: Mode = "both",
    always_tools: bool = False,
    direct_runs: int = 1,
    pool: Pool = "procedural",
    split: Path | None = None,
    noise: NoiseName = "none",
    lighting: LightKind = "ambient",
    points: Points | None = None,
    endpoint: str | None = None,
    prices: Path | None = None,
    most_episodes: int | None = None,
    most_cost: float | None = None,
    workers: int = 2,
    shard: str = "0/1",
    batch: int = 48,
    first: int = FIRST_EPISODE,
) -> None:
    """Collect a teacher's episodes on fresh training tasks; goes on where an earlier run stopped.

    Without a model the scripted teacher works, which gives its reasons in words.

    Args:
        out: Folder for tasks and records.
        counts: Tasks of each type to be answered rightly; by default the paper's.
        total: So many in all instead, in the proportions of the counts.
        model: A model that teaches, by a name of docs/models.md or the harness's own.
        arms: Without tools first, then with tools what that didn't answer ("both"), or one alone.
        always_tools: With tools all tasks, even if the first picture was enough.
        direct_runs: Episodes of each task without tools; all must be right to count as known.
        pool: Which objects appear.
        split: Take the training part of this split alone (`probe assets split`).
        noise: How far the hand errs.
        lighting: Of the pictures.
        points: How places are counted; by default as suits the model, or in pixels.
        endpoint: Address of a server that speaks OpenAI's protocol.
        prices: A file that says what tokens cost.
        most_episodes: Stop after so many episodes.
        most_cost: Stop before more than so many US dollars are spent; needs prices.
        workers: Processes.
        shard: "0/2" and "1/2" on two machines share the work, into a folder each.
        batch: Tasks that are made and played at a time, at most.
        first: Number of the first episode; training starts at 2,000,000.
    """
    if first < FIRST_EPISODE:
        raise BadData("--first", f"{first} isn't for training", f"Say {FIRST_EPISODE} or more")
    if most_cost is not None and model is not None and prices is None:
        raise BadData("--most-cost", "nobody knows what tokens cost", "Add --prices FILE")
    counting = points or (settings_of(model).points if model else "pixels")
    part = Shard(*parse_shard(shard))
    site = _Site(model, split, pool, noise, lighting, counting, workers)
    aim = Aim(
        counts=counts if total is None else in_proportion(counts, total),
        first=first,
        shard=part,
        mode=arms,
        always=always_tools,
        direct_runs=direct_runs,
        batch=batch,
        most_episodes=most_episodes,
        most_cost=most_cost,
    )
    if not aim.total:
        raise BadData("--counts", "asks for nothing", 'Say "--counts.find 20"')
    claim(out, site.settings)
    print(f"Episodes go to {out}; Ctrl-C stops, the same command goes on.")
    play = site.taught() if model is None else site.seated(model, endpoint, prices)
    so_far = _watched(out, aim, site.hands(out, play))
    _tell(out, aim, so_far)


@dataclass(frozen=True)
class _Site:
    """Where and how it is collected."""

    model: str | None
    split: Path | None
    pool: Pool
    noise: NoiseName
    lighting: LightKind
    points: Points
    workers: int

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
            points=self.points,
            noise=self.noise,
            lighting=self.lighting,
        )

    @property
    def conditions(self) -> Conditions:
        """In what episodes differ from tasks."""
        return Conditions(lighting=self.lighting)

    def hands(self, out: Path, play: Play) -> Hands:
        """Who does the work."""
        studio = Studio(
            Parts(out / TASKS), self.training, tables_for(self.pool), cache_folder() / "light"
        )
        things = self.training()
        return Hands(
            make=partial(make_tasks, studio, workers=self.workers),
            play=play,
            library=things,
            darkroom=lambda suite: Darkroom(suite, lambda: things, assets_folder()),
        )

    def taught(self) -> Play:
        """The scripted teacher plays."""
        order = Order(TEACHER, 1, NOISES[self.noise], self.conditions, points=self.points)

        def play(suite: Suite, arm: Arm, runs: int, out: Path) -> Iterable[str]:
            mine = replace(order, arm=arm, runs=runs)
            place = Classroom(
                mine, self.training, teacher_for(self.points), cache_folder() / "light"
            )
            with begun(out, suite, mine) as beginning:
                jobs = beginning.jobs
                with closing(work(out, jobs, place, self.workers)) as results:
                    for number, (job, fault) in enumerate(results, start=1):
                        doing = f"{number} of {len(jobs)} {arm} episodes"
                        yield f"{doing}; {job.task.id}: {fault}" if fault else doing

        return play

    def seated(self, model: str, endpoint: str | None, prices: Path | None) -> Play:
        """A model plays, through the harness."""
        seats = Seats(
            model,
            "agentic",
            1,
            self.points,
            "oracle",
            endpoint,
            prices,
            NOISES[self.noise],
            self.conditions,
            Shard(),
            self.workers,
        )

        def play(suite: Suite, arm: Arm, runs: int, out: Path) -> Iterator[str]:
            yield f"{len(suite.tasks)} tasks go to {model} ({arm})"
            take_seats(suite, replace(seats, arm=arm, epochs=runs), out, dry_run=False)

        return play


def _watched(out: Path, aim: Aim, hands: Hands) -> Harvest:
    """Collect, with a bar of the successes that are wanted."""
    so_far = Harvest()
    with progress_bar() as bar:
        line = bar.add_task("Collecting", total=aim.total)
        for step in collected(out, aim, hands):
            so_far = step.so_far
            bar.update(line, completed=aim.reached(so_far), description=step.doing)
    return so_far


def _tell(out: Path, aim: Aim, so_far: Harvest) -> None:
    reached = aim.reached(so_far)
    for kind in sorted(aim.counts):
        tried, right = so_far.tasks[kind], so_far.successes[kind]
        share = f" ({right / tried:.0%})" if tried else ""
        print(f"{kind}: {right} of {aim.wanted(kind)} wanted; {tried} tasks tried{share}")
    for arm, played in sorted(so_far.played.items()):
        print(f"{arm}: {so_far.right[arm]} of {played} episodes were right")
    cost = f"{so_far.cost:,.2f} US dollars"
    if so_far.unpriced:
        cost += f", without {so_far.unpriced} episodes that have no price"
    print(f"{so_far.episodes} episodes, {so_far.missing} missing by our fault; {cost}.")
    if reached < aim.total:
        print(f"The budget of {aim.spent(so_far)} is spent: {reached} of {aim.total} are there.")
    print(f"Tasks and records are in {out}; `probe select {out}` chooses among them.")
