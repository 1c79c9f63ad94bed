"""`probe run`: let an agent work on a suite."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.cli.agents import AgentName, make_agent
from probe.cli.running import run_order
from probe.cli.shards import parse_shard
from probe.cli.surroundings import everything
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.folder import RECORDS
from probe.episodes.luck import NOISES, NoiseName
from probe.runs.plan import Order, Shard
from probe.tasks.suite_file import find_suite


def run(
    suite: Annotated[str, tyro.conf.Positional],
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
        suite: One of the package ("v1", "demo"), or a file that `probe suite build` wrote.
        agent: Who acts; none of these needs a model.
        out: Folder for the records.
        runs: Episodes of each task.
        noise: How far the hand errs; "paper" fails as often as the paper's.
        workers: Processes that run episodes.
        shard: "0/2" and "1/2" on two machines share the work; `probe merge` joins their folders.
        conditions: In what episodes differ from their tasks; see docs/run.md.
    """
    order = Order(agent, runs, NOISES[noise], conditions, Shard(*parse_shard(shard)))
    run_order(find_suite(suite), order, make_agent, everything(), out, workers)
    print(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")
