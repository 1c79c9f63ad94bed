"""`probe run` and `probe report`: let an agent work on a suite, and show what it did."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal

import tyro
from PIL import Image
from rich.progress import track

from probe.agents.random import Random
from probe.agents.scripted import Scripted
from probe.assets.tables import load_table
from probe.cli.running import run_order
from probe.cli.shards import parse_shard
from probe.cli.surroundings import assets_folder, everything
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE, in_order
from probe.episodes.luck import NOISES, NoiseName
from probe.episodes.pictures import frames
from probe.episodes.play import score
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Agent
from probe.errors import BadData
from probe.files import encode, write_bytes
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.report.episode_view import EpisodeView
from probe.report.page import write_report
from probe.report.tally import rates
from probe.runs.plan import Order, Shard
from probe.scene.seeds import generator
from probe.tasks.grading import Score
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task

AgentName = Literal["scripted", "random"]

_PICTURE_PX = 512


def run(
    suite: Annotated[Path, tyro.conf.Positional],
    agent: AgentName = "scripted",
    out: Path = Path("outputs/run"),
    runs: int = 1,
    noise: NoiseName = "none",
    workers: int = 1,
    shard: str = "0/1",
    conditions: Annotated[Conditions, tyro.conf.arg(name="")] = AS_FROZEN,
) -> None:
    """Let an agent work on every task of a suite; goes on where an earlier run stopped.

    Args:
        suite: A file that `probe suite build` wrote.
        agent: Who acts; neither needs a model.
        out: Folder for the records.
        runs: Episodes of each task.
        noise: How far the hand errs; "paper" fails as often as the paper's.
        workers: Processes that run episodes.
        shard: "0/2" and "1/2" on two machines share the work; `probe merge` joins their folders.
        conditions: In what episodes differ from their tasks; see docs/run.md.
    """
    order = Order(agent, runs, NOISES[noise], conditions, Shard(*parse_shard(shard)))
    run_order(read_suite(suite), order, make_agent, everything(), out, workers)
    print(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")


def report(out: Annotated[Path, tyro.conf.Positional]) -> None:
    """Grade a run's records and write a page of them; needs no physics.

    Args:
        out: Folder that `probe run` wrote to.
    """
    print(f"The report is {write_run_report(out)}")


def write_run_report(out: Path) -> Path:
    """Draw and grade every record of a folder; returns the page."""
    suite = read_suite(out / SUITE)
    views: list[EpisodeView] = []
    with Renderer() as renderer:
        for task, record in _loaded(out, suite, renderer):
            views.append(_view(out, task, record, renderer))
    page = out / "index.html"
    write_report(page, f"PROBE: suite {suite.name}", views)
    total = rates(views)[-1]
    print(f"{total.right} of {total.n} right (95 % interval {total.low:.0%} to {total.high:.0%})")
    return page


def graded(out: Path) -> Iterator[tuple[Task, EpisodeRecord, Score]]:
    """Every record of a folder with its task and what it is worth, by task, agent and run.

    Raises:
        BadData: The suite or a record can't be read, or a record is about something else.
        OtherTask: A task has changed since.
    """
    with Renderer() as renderer:
        for task, record in _loaded(out, read_suite(out / SUITE), renderer):
            yield task, record, score(task, record, renderer)


def _loaded(out: Path, suite: Suite, renderer: Renderer) -> Iterator[tuple[Task, EpisodeRecord]]:
    """Every record of a folder with its task, whose objects the renderer then has."""
    tasks, things = {task.id: task for task in suite.tasks}, everything()
    for record in track(in_order(read_records(out / RECORDS), suite), "Drawing and grading"):
        if record.task not in tasks:
            remedy = "Move one of them elsewhere"
            raise BadData(out / RECORDS, f"{record.task} is not in {SUITE}", remedy)
        task = tasks[record.task]
        start = record.start.scene
        load_scene(renderer, start, things, load_table(start.table, assets_folder()))
        yield task, record


def _view(out: Path, task: Task, record: EpisodeRecord, renderer: Renderer) -> EpisodeView:
    pictures: list[str] = []
    for number, frame in enumerate(frames(record, renderer, assets_folder())):
        name = f"pictures/{record.task}-{record.agent}-{record.run}/{number}.jpg"
        assert frame.rgb is not None
        small = Image.fromarray(frame.rgb).resize((_PICTURE_PX, _PICTURE_PX), Image.Resampling.BOX)
        write_bytes(out / name, encode(small, "JPEG"))
        pictures.append(name)
    return EpisodeView(
        task.kind, record, score(task, record, renderer), task.answer, tuple(pictures)
    )


def make_agent(name: str, task: Task, number: int) -> Agent:
    """A fresh agent by its name; see probe.runs.work.AgentOf."""
    rng = generator(task.seed, "run", name, number)
    return (
        Random(rng) if name == "random" else Scripted(task.kind, task.subject, rng, form=task.form)
    )
