"""`probe run` and `probe report`: let an agent work on a suite, and show what it did."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import tyro

from probe.agents.random import Random
from probe.agents.scripted import Scripted
from probe.cli.running import run_order
from probe.cli.shards import parse_shard
from probe.cli.surroundings import everything
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.folder import RECORDS
from probe.episodes.luck import NOISES, NoiseName
from probe.episodes.turns import Agent
from probe.runs.plan import Order, Shard
from probe.scene.seeds import generator
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


def make_agent(name: str, task: Task, number: int) -> Agent:
    """A fresh agent by its name; see probe.runs.work.AgentOf."""
    rng = generator(task.seed, "run", name, number)
    return (
        Random(rng) if name == "random" else Scripted(task.kind, task.subject, rng, form=task.form)
    )
