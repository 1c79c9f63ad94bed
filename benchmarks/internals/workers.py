"""What worker processes of `probe run` cost: `python benchmarks/internals/workers.py --help`.

Measures internals, not the public API.

Two workers against two runs of one worker each that know nothing of each other, in turn on the same
episodes; then where the time of an episode goes. Ratios are of wall times of whole commands. On a
machine that others use, take the ratios, not the seconds.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

import tyro

import probe.manipulation
from probe.api.agents import make_agent
from probe.api.resources import everything
from probe.episodes.files import append_line
from probe.render.renderer import Renderer
from probe.runs.plan import Job, RunOrder
from probe.runs.work import WorkerSetup
from probe.tasks.suite import Suite
from probe.tasks.suite_file import demo_suite, read_suite, write_suite
from probe.world.world import World

NAMED = ("physics", "planning", "rendering")


def start(suite: Path, out: Path, runs: int, *more: str) -> subprocess.Popen[bytes]:
    """A `probe run` that has been started."""
    words = ["run", str(suite), "--out", str(out), "--runs", str(runs), *more]
    return subprocess.Popen([sys.executable, "-m", "probe", *words], stdout=subprocess.DEVNULL)


def seconds(*begun: subprocess.Popen[bytes], since: float) -> float:
    """Wall time until all of them have ended well."""
    for process in begun:
        if process.wait() != 0:
            sys.exit("a run failed; see above")
    return time.perf_counter() - since


def together(suite: Path, out: Path, runs: int) -> float:
    """Wall time of one run with two workers."""
    since = time.perf_counter()
    return seconds(start(suite, out / "both", runs, "--workers", "2"), since=since)


def apart(suite: Path, out: Path, runs: int) -> float:
    """Wall time of two runs with one worker each, at the same time, each with half of it."""
    since = time.perf_counter()
    halves = [start(suite, out / part, runs, "--shard", f"{part}/2") for part in "01"]
    return seconds(*halves, since=since)


class Clock:
    """Wall time by what was being done, each moment counted once: for the innermost of it."""

    def __init__(self) -> None:
        self.spent: dict[str, float] = defaultdict(float)
        self._doing = ["the rest"]
        self._since = time.perf_counter()

    def switch(self) -> None:
        """Account for the time since the last switch."""
        now = time.perf_counter()
        self.spent[self._doing[-1]] += now - self._since
        self._since = now

    def timed(self, name: str, act: Callable[..., Any]) -> Callable[..., Any]:
        """The same function, its time accounted for."""

        def timed(*arguments: Any, **named: Any) -> Any:
            self.switch()
            self._doing.append(name)
            try:
                return act(*arguments, **named)
            finally:
                self.switch()
                self._doing.pop()

        return timed

    def watch(self, owner: Any, attribute: str, name: str) -> None:
        """Time a function wherever it is called from."""
        setattr(owner, attribute, self.timed(name, getattr(owner, attribute)))


def shares(suite: Suite, runs: int) -> dict[str, float]:
    """Seconds by what a worker was at, in this process."""
    clock = Clock()
    for owner, attribute, name in (
        (World, "__init__", "physics"),
        (World, "step", "physics"),
        (World, "object_speed", "physics"),
        (Renderer, "_ask", "rendering"),
        (probe.manipulation, "grasp_and_remove", "planning"),
        (probe.manipulation, "push", "planning"),
    ):
        clock.watch(owner, attribute, name)
    place = WorkerSetup(RunOrder("scripted", runs), everything, make_agent)
    with tempfile.TemporaryDirectory() as folder, place() as carry:
        carry(Job(suite.tasks[0], 0))  # starts the renderer
        clock.switch()
        clock.spent.clear()
        for job in place.order.jobs(suite.tasks):
            append_line(Path(folder) / "records.jsonl", carry(job))
        clock.switch()
    return dict(clock.spent)


def main(suite: Path | None = None, episodes: int = 60, rounds: int = 2) -> None:
    """Measure with the scripted agent.

    Args:
        suite: A suite's file; the demo suite if none is given.
        episodes: Of each of both ways, over all rounds; a whole number of runs of the suite.
        rounds: How often both ways take turns.
    """
    tasks = demo_suite() if suite is None else read_suite(suite)
    runs = max(1, round(episodes / rounds / len(tasks.tasks)))
    both, halves = 0.0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "suite.json"
        write_suite(path, tasks)
        for turn in range(rounds):
            out = Path(folder) / str(turn)
            # Who comes first changes, so that a machine that slows down favours nobody.
            for way in (together, apart) if turn % 2 == 0 else (apart, together):
                taken = way(path, out, runs)
                both, halves = (both + taken, halves) if way is together else (both, halves + taken)
                print(f"round {turn + 1}, {way.__name__}: {taken:.0f} s", flush=True)
    count = runs * rounds * len(tasks.tasks)
    print(f"{count} episodes each way, {rounds} rounds: two workers {both:.0f} s,")
    print(f"two runs of one worker {halves:.0f} s: ratio {halves / both:.2f} (aim: at least 0.9)")
    spent = shares(tasks, 1)
    total = sum(spent.values())
    words = ", ".join(f"{name} {spent[name] / total:.0%}" for name in (*NAMED, "the rest"))
    print(f"{len(tasks.tasks)} episodes in one worker: {words} (aim: the rest under 10 %)")


if __name__ == "__main__":
    tyro.cli(main)
