"""`probe run` and `probe report`: let an agent work on a suite, and show what it did."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import tyro
from PIL import Image
from rich.progress import track

from probe.assets.tables import load_table
from probe.cli.agents import AgentName
from probe.cli.agents import agent as make_agent
from probe.cli.surroundings import assets_folder, everything
from probe.episodes.files import append_record, read_records
from probe.episodes.folder import RECORDS, SUITE, start_folder
from probe.episodes.luck import NOISES, Noise, NoiseName
from probe.episodes.pictures import frames
from probe.episodes.play import play, score
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import encode, write_bytes
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.report.episode_view import EpisodeView
from probe.report.page import write_report
from probe.report.tally import rates
from probe.tasks.grading import Score
from probe.tasks.suite import Suite, check_objects
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task

_PICTURE_PX = 512


def run(
    suite: Annotated[Path, tyro.conf.Positional],
    agent: AgentName = "scripted",
    out: Path = Path("outputs/run"),
    runs: int = 1,
    noise: NoiseName = "none",
) -> None:
    """Let an agent work on every task of a suite; goes on where an earlier run stopped.

    Args:
        suite: A file that `probe suite build` wrote.
        agent: Who acts; none needs a model.
        out: Folder for the records.
        runs: Episodes of each task.
        noise: How far the hand errs; "paper" fails as often as the paper's.
    """
    run_suite(read_suite(suite), agent, out, runs, NOISES[noise])
    print(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")


def report(out: Annotated[Path, tyro.conf.Positional]) -> None:
    """Grade a run's records and write a page of them; needs no physics.

    Args:
        out: Folder that `probe run` wrote to.
    """
    print(f"The report is {write_run_report(out)}")


def run_suite(suite: Suite, agent: AgentName, out: Path, runs: int, noise: Noise) -> None:
    """Add the records that a folder doesn't hold yet, and the suite they are about.

    Raises:
        BadData: What is there was run with another noise, or is about another suite.
    """
    things = everything()
    check_objects(suite, things)
    records = out / RECORDS
    earlier = read_records(records) if records.exists() else []
    if any(record.noise != noise for record in earlier):
        raise BadData(records, "was run with another noise", "Choose another folder")
    start_folder(out, suite)
    done = {(record.task, record.agent, record.run) for record in earlier}
    waiting = [
        (task, number)
        for task in suite.tasks
        for number in range(runs)
        if (task.id, agent, number) not in done
    ]
    with Renderer() as renderer:
        for task, number in track(waiting, f"{agent} at work"):
            table = load_table(task.scene.table, assets_folder())
            actor = make_agent(agent, task, number, things, renderer)
            record = play(task, actor, agent, things, table, renderer, number, noise)
            append_record(records, record)


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
    """Every record of a folder with its task and what it is worth, in the order of the file.

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
    for record in track(read_records(out / RECORDS), "Drawing and grading"):
        if record.task not in tasks:
            remedy = "Move one of them elsewhere"
            raise BadData(out / RECORDS, f"{record.task} is not in {SUITE}", remedy)
        task = tasks[record.task]
        load_scene(renderer, task.scene, things, load_table(task.scene.table, assets_folder()))
        yield task, record


def _view(out: Path, task: Task, record: EpisodeRecord, renderer: Renderer) -> EpisodeView:
    pictures: list[str] = []
    for number, frame in enumerate(frames(record, renderer)):
        name = f"pictures/{record.task}-{record.agent}-{record.run}/{number}.jpg"
        assert frame.rgb is not None
        small = Image.fromarray(frame.rgb).resize((_PICTURE_PX, _PICTURE_PX), Image.Resampling.BOX)
        write_bytes(out / name, encode(small, "JPEG"))
        pictures.append(name)
    return EpisodeView(
        task.kind, record, score(task, record, renderer), task.answer, tuple(pictures)
    )
