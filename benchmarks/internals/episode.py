"""What a scripted episode without pictures costs: `python benchmarks/internals/episode.py --help`.

Measures internals, not the public API.

CPU seconds, split by tool and into our process (planning, physics, perception) and the render
worker with its children.
"""

from __future__ import annotations

import time
from collections import defaultdict
from importlib import resources
from pathlib import Path

import numpy as np
import psutil
import tyro
from rich.console import Console
from rich.table import Table

from probe.agents.scripted import Scripted
from probe.api.resources import assets_folder, cache_folder
from probe.assets.library import Library, open_library
from probe.episodes.grading import question_of
from probe.episodes.play import set_table
from probe.episodes.run import run_episode
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult
from probe.toolshed.toolshed import Toolshed


class Metered:
    """Tools that note the CPU seconds of every call, here and in the render worker."""

    def __init__(self, tools: Toolshed, renderer: Renderer) -> None:
        self.spent: dict[str, list[tuple[float, float]]] = defaultdict(list)
        self._tools, self._renderer = tools, renderer

    @property
    def ended(self) -> bool:
        return self._tools.ended

    @property
    def answer(self):
        return self._tools.answer

    def call(self, name: str, arguments: object) -> ToolResult:
        here, there = time.process_time(), worker_seconds(self._renderer)
        result = self._tools.call(name, arguments)
        ended = worker_seconds(self._renderer)
        self.spent[name].append((time.process_time() - here, ended - there))
        return result


def worker_seconds(renderer: Renderer) -> float:
    """CPU seconds of the render worker and all its children, also those that have ended."""
    worker = psutil.Process(renderer.pid)
    total = 0.0
    for process in [worker, *worker.children(recursive=True)]:
        used = process.cpu_times()
        total += used.user + used.system
        if process is worker:
            total += used.children_user + used.children_system
    return total


def episode(task: Task, things: Library, renderer: Renderer) -> tuple[float, Metered]:
    """CPU seconds of all of it, setting the table included, and the tools that were used."""
    here, there = time.process_time(), worker_seconds(renderer)
    tools, station = set_table(task, things, renderer, pictures=False)
    metered = Metered(tools, renderer)
    agent = Scripted(task.question_type, task.subject, generator(task.seed, "run", "benchmark"))
    run_episode(
        task.id,
        question_of(task),
        agent,
        metered,  # pyright: ignore[reportArgumentType]  # a meter around the tools
        station,
        agent_name="scripted",
    )
    whole = time.process_time() - here + worker_seconds(renderer) - there
    return whole, metered


def main(suite: Path | None = None) -> None:
    """Run the scripted agent once on each task.

    Args:
        suite: A suite's file; the demo suite if none is given.
    """
    with resources.as_file(resources.files("probe.tasks") / "data/demo.json") as demo:
        tasks = read_suite(suite or demo).tasks
    pool = "all" if assets_folder() else "procedural"
    things = open_library(pool, assets_folder(), cache_folder())
    wholes: list[float] = []
    spent: dict[str, list[tuple[float, float]]] = defaultdict(list)
    with Renderer() as renderer:
        episode(tasks[0], things, renderer)  # warms caches up
        for task in tasks:
            whole, metered = episode(task, things, renderer)
            wholes.append(whole)
            for name, seconds in metered.spent.items():
                spent[name] += seconds
    calls = Table("tool", "calls an episode", "CPU s a call: here", "render worker", "share of all")
    for name, seconds in sorted(spent.items()):
        here, there = np.array(seconds).mean(axis=0)
        share = float(np.sum(seconds)) / sum(wholes)
        often = len(seconds) / len(tasks)
        calls.add_row(name, f"{often:.1f}", f"{here:.2f}", f"{there:.2f}", f"{share:.0%}")
    Console().print(calls)
    print(
        f"{len(tasks)} episodes without pictures: CPU s mean {np.mean(wholes):.1f}, "
        f"median {np.median(wholes):.1f}, most {max(wholes):.1f}; "
        f"outside the tools {1 - sum(map(np.sum, spent.values())) / sum(wholes):.0%}"
    )


if __name__ == "__main__":
    tyro.cli(main)
