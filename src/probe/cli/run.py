"""`probe run`: let an agent work on a suite."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.progress import track

from probe.agents.random import Random
from probe.agents.scripted import Scripted
from probe.assets.tables import load_table
from probe.cli.surroundings import assets_folder, everything
from probe.episodes.files import append_record, read_records
from probe.episodes.folder import RECORDS, start_folder
from probe.episodes.luck import NOISES, Noise, NoiseName
from probe.episodes.play import play
from probe.episodes.turns import Agent
from probe.errors import BadData
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.suite import Suite, check_objects
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task

AgentName = Literal["scripted", "random"]


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
        agent: Who acts; neither needs a model.
        out: Folder for the records.
        runs: Episodes of each task.
        noise: How far the hand errs; "paper" fails as often as the paper's.
    """
    run_suite(read_suite(suite), agent, out, runs, NOISES[noise])
    print(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")


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
            actor = _agent(agent, task, number)
            record = play(task, actor, agent, things, table, renderer, number, noise)
            append_record(records, record)


def _agent(name: AgentName, task: Task, number: int) -> Agent:
    rng = generator(task.seed, "run", name, number)
    return (
        Random(rng) if name == "random" else Scripted(task.kind, task.subject, rng, form=task.form)
    )
