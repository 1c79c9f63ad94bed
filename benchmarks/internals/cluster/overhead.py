"""What a Ray cluster costs: `PYTHONPATH=tests python benchmarks/internals/cluster/overhead.py`.

Measures internals, not the public API. The same episodes by two worker processes and by two Ray
nodes of one core each, in turn on this machine; wall times of whole commands, the time until the
first record, and the memory that the second node takes, its worker included. Take the ratios. A
quarter of an hour on two cores, which nobody else should use.
"""

from __future__ import annotations

import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import psutil
import tyro
from measured_runs import start, write_tasks

from engines.ray_nodes import Nodes, two_nodes
from probe.assets.folders import cache_folder
from untimed import lines

HERE, THERE = ("--workers", "2"), ("--on", "ray")
MEGABYTE = 1e6


@dataclass(frozen=True)
class Measured:
    """One command.

    Attributes:
        whole: Seconds until it ended.
        first: Seconds until its first record was there.
        memory: The most that the second node's processes held, bytes; shared pages count once.
    """

    whole: float
    first: float
    memory: int

    def __str__(self) -> str:
        return (
            f"{self.whole:.0f} s, first record after {self.first:.0f} s, "
            f"second node {self.memory / MEGABYTE:.0f} MB"
        )


def measured(suite: Path, out: Path, runs: int, how: tuple[str, ...], nodes: Nodes) -> Measured:
    """Carry a run out and watch it."""
    records = out / "records.jsonl"
    since = time.perf_counter()
    process = start(("run", suite, "--out", out, "--runs", runs, *how), nodes.environment)
    first, memory = float("nan"), 0
    while process.poll() is None:
        if first != first and records.exists() and records.stat().st_size:
            first = time.perf_counter() - since
        memory = max(memory, held(nodes.second))
        time.sleep(0.5)
    if process.returncode != 0:
        sys.exit(process.communicate()[0])
    return Measured(time.perf_counter() - since, first, memory)


def held(started: list[psutil.Process]) -> int:
    """Memory of processes and their children, bytes."""
    total = 0
    for process in started:
        with suppress(psutil.Error):
            for one in (process, *process.children(recursive=True)):
                with suppress(psutil.Error):
                    total += one.memory_full_info().pss
    return total


def main(tasks: int = 20, runs: int = 3, rounds: int = 2) -> None:
    """Measure and print.

    Args:
        tasks: Of v1.
        runs: Episodes of each.
        rounds: How often each way is measured.
    """
    with tempfile.TemporaryDirectory() as kept, two_nodes(cache=cache_folder()) as nodes:
        suite = write_tasks(Path(kept) / "suite.json", tasks)
        idle = held(nodes.second)
        print(f"{tasks * runs} episodes; an idle node holds {idle / MEGABYTE:.0f} MB", flush=True)
        expected: list[bytes] = []
        for turn in range(rounds):
            of: dict[str, Measured] = {}
            for name, how in (("workers", HERE), ("ray", THERE)):
                out = Path(kept) / f"{name}-{turn}"
                of[name] = measured(suite, out, runs, how, nodes)
                expected = expected or lines(out)
                same = lines(out) == expected and len(expected) == tasks * runs
                print(f"{name:8} {of[name]}; same records: {same}", flush=True)
            print(f"ray / workers: {of['ray'].whole / of['workers'].whole:.3f}", flush=True)


if __name__ == "__main__":
    tyro.cli(main)
