"""What a Ray cluster loses: `PYTHONPATH=tests python benchmarks/internals/cluster/kills.py`.

Measures internals, not the public API. Work is done once by local workers, then on two Ray nodes
of one core each, where a worker, the second node or the command itself is killed at random moments,
ten times each. Printed for each victim: whether results are the same, byte for byte, and what files
are left over. `--work tasks` builds tasks instead of doing episodes; `--store` has results and
assets come through a server that speaks S3's protocol. Half an hour each on two cores.
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import fsspec
import psutil
import tyro
from measured_runs import start, write_tasks

from engines.ray_nodes import Nodes, nodes_and_store
from probe.assets.folders import cache_folder
from untimed import lines

Victim = Literal["worker", "node", "driver"]
AGAIN = ("The same command tries them again", "The same command goes on")
TYPES = ("beneath", "compare", "count", "find", "reduce", "size")


@dataclass(frozen=True)
class Work:
    """Something that a command does.

    Attributes:
        command: For a folder.
        result: What came of it there, as bytes that should always be the same.
    """

    command: Callable[[Path], tuple[object, ...]]
    result: Callable[[Path], list[bytes]]


def episodes(suite: Path) -> Work:
    """Sixty episodes."""
    return Work(lambda out: ("run", suite, "--out", out, "--runs", 3), lines)


def tasks() -> Work:
    """Two kept tasks of each type of v1."""
    counts = [word for name in TYPES for word in (f"--counts.{name}", 2)]
    return Work(
        lambda out: ("suite", "build", out / "built.json", "--public", *counts),
        lambda out: [(out / "built.json").read_bytes()],
    )


@dataclass
class Trial:
    """Work on a cluster whose parts die.

    Attributes:
        nodes: The cluster.
        victim: What dies.
        draw: Decides when, and which.
        kills: Times at which something died, seconds since the start.
        repeats: How often the command ended before all was done and was given again, as it said:
            three workers had died over a unit, or one after another while they set up.
    """

    nodes: Nodes
    victim: Victim
    draw: random.Random
    kills: list[float] = field(default_factory=list[float])
    repeats: int = 0

    def carry_out(self, command: tuple[object, ...], most: int) -> None:
        """Do the work; what is killed is started again.

        Args:
            command: Of `probe`.
            most: Kills.
        """
        since = time.perf_counter()
        process = start(command, self.nodes.environment)
        while True:
            with suppress(subprocess.TimeoutExpired):
                said, _ = process.communicate(timeout=self.draw.uniform(5, 25))
                if process.returncode == 0:
                    return
                if not any(words in said for words in AGAIN):
                    sys.exit(said)
                self.repeats += 1
                process = start(command, self.nodes.environment)
                continue
            if len(self.kills) < most and self._kill(process):
                self.kills.append(time.perf_counter() - since)
                if self.victim == "node":
                    self.nodes.add_second()
                elif self.victim == "driver":
                    process = start(command, self.nodes.environment)

    def _kill(self, driver: subprocess.Popen[str]) -> bool:
        """Whether there was anything to kill."""
        if self.victim == "node":
            self.nodes.kill_second()
            return True
        if self.victim == "driver":
            driver.kill()
            driver.communicate()
            return True
        workers = [one for one in psutil.process_iter() if self._is_ours(one)]
        if not workers:
            return False
        self.draw.choice(workers).kill()
        return True

    def _is_ours(self, process: psutil.Process) -> bool:
        """Whether it is a worker of this cluster; others may run on this machine."""
        try:
            if not process.name().startswith("ray::RayWorker"):
                return False
            parent = process.parent()
            return parent is not None and str(self.nodes.folder) in " ".join(parent.cmdline())
        except psutil.Error:
            return False


def left_over(out: Path, store: str | None) -> list[str]:
    """Files of the engine that nobody has removed."""
    files = [str(path.relative_to(out)) for path in out.glob("units-*")]
    files += [str(path.relative_to(out)) for path in out.rglob(".*") if path.is_file()]
    if store is not None:
        objects = fsspec.filesystem("s3", use_listings_cache=False)
        files += [name for name in objects.find(store) if "/assets/" not in name]
    return files


def main(
    work: Literal["episodes", "tasks"] = "episodes",
    victims: tuple[Victim, ...] = ("worker", "node", "driver"),
    kills: int = 10,
    store: bool = False,
    seed: int = 0,
) -> None:
    """Kill and print.

    Args:
        work: What is done.
        victims: What dies.
        kills: How often each.
        store: Whether results and assets come through an object store.
        seed: Of the moments.
    """
    os.environ.pop("PROBE_ASSETS", None)  # v1's things are drawn, not scanned
    with tempfile.TemporaryDirectory() as kept, nodes_and_store(cache_folder()) as nodes:
        os.environ.update(nodes.environment)
        if store:
            fsspec.filesystem("s3").mkdir("work")
        todo = tasks() if work == "tasks" else episodes(write_tasks(Path(kept) / "s.json", 20))
        here = Path(kept) / "here"
        done = start((*todo.command(here), "--workers", 2), {})
        said, _ = done.communicate()
        if done.returncode != 0:
            sys.exit(said)
        expected = todo.result(here)
        for victim in victims:
            trial = Trial(nodes, victim, random.Random(f"{seed} {victim}"))
            for turn in range(kills):
                if len(trial.kills) >= kills:
                    break
                out = Path(kept) / f"{victim}-{turn}"
                url = f"s3://work/{victim}-{turn}" if store else None
                where = ("--on", "ray", *(("--store", url) if url else ()))
                trial.carry_out((*todo.command(out), *where), kills)
                same = todo.result(out) == expected
                print(
                    f"{work}, {victim} killed {len(trial.kills)} times so far: "
                    f"same bytes {same}, left over {left_over(out, url)}, "
                    f"repeated {trial.repeats} times",
                    flush=True,
                )
            print(f"{victim}: at {[round(at) for at in trial.kills]} s", flush=True)


if __name__ == "__main__":
    tyro.cli(main)
