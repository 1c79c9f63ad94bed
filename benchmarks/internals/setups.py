"""Whether set-ups of one's own work from end to end: `python benchmarks/internals/setups.py`.

Measures internals, not the public API.

For each set-up: do scenes settle, what do the tools say of its sizes, and how many tasks that are
built for it, of the demo's types, does the scripted agent solve? Procedural objects.
"""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import tyro

import probe
from probe.agents.scripted import Scripted
from probe.errors import Unsatisfiable
from probe.scene.seeds import generator
from probe.tasks.suite_file import demo_suite
from probe.toolshed.tools import tool_schemas

SETUPS = Path(__file__).parents[2] / "examples" / "setups"


def settled(setup: probe.Setup, library: probe.Library, count: int) -> int:
    """How many of so many seeds give a scene."""
    made = 0
    for seed in range(count):
        try:
            probe.make_scene(seed, library, setup=setup)
        except Unsatisfiable:
            continue
        made += 1
    return made


def solved(suite: probe.Suite, library: probe.Library, renderer: probe.Renderer) -> list[str]:
    """Types of the tasks that the scripted agent, which never guesses, answers rightly."""
    right: list[str] = []
    for task in suite.tasks:
        rng = generator(task.seed, "setups")
        agent = Scripted(task.question_type, task.subject, rng, form=task.form)
        record = probe.play(task, agent, library, pictures=False, renderer=renderer)
        if probe.score(task, record, library, renderer=renderer).correct:
            right.append(task.question_type)
    return right


def sizes_told(task: probe.Task) -> str:
    """What the tools say of the set-up's sizes."""
    tools = {tool.name: tool for tool in tool_schemas(task.scale)}
    distance = tools["push"].parameters["properties"]["distance_cm"]["description"]
    grasp = tools["grasp_and_remove"].description
    grip = grasp[grasp.index(" The gripper opens") :] if "The gripper opens" in grasp else ""
    return distance.partition(". ")[2] + grip


def main(
    setups: Sequence[Path] = tuple(sorted(SETUPS.glob("*.json"))),
    scenes: int = 5,
    unchecked: bool = False,
) -> None:
    """Print what came of each set-up.

    Args:
        setups: Files.
        scenes: How many to settle for each.
        unchecked: Keep tasks that no scripted agent solved, too; the demo's tasks are solved ones.
    """
    types = Counter(task.question_type for task in demo_suite().tasks)
    library = probe.open_library()
    for path in setups:
        setup = probe.read_setup(path)
        print(
            f"{setup.name}: {settled(setup, library, scenes)} of {scenes} scenes settle", flush=True
        )
        with tempfile.TemporaryDirectory() as folder, probe.Renderer() as renderer:
            out = Path(folder) / f"of-{setup.name}.json"
            suite = probe.build_suite(out, types, public=True, certified=not unchecked, setup=setup)
            print(f"  {sizes_told(suite.tasks[0])}", flush=True)
            right = solved(suite, library, renderer)
        print(
            f"  scripted solves {len(right)} of {len(suite.tasks)}: {', '.join(right)}", flush=True
        )


if __name__ == "__main__":
    tyro.cli(main)
