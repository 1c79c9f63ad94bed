"""Whether what the tools say after a manipulation is true.

`python benchmarks/internals/outcomes/measure.py --help`. Measures internals, not the public API.

A random agent grasps and pushes things that show, on fresh scenes, every second one a dense pile.
Each reply is held against where things really are. Every result is kept as a line of the file, and
seeds that the file has are not done again. About 12 seconds a manipulation on one core.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Literal

import numpy as np
import tyro
from claims import Table, Verdict, judge
from pictures import Moments, keep
from rich.console import Console
from rich.progress import track
from scipy.stats import binomtest

from probe.agents.reading import read_graph, read_handle
from probe.api.resources import library, tables_for
from probe.assets.library import Library
from probe.episodes.arm_skills import ArmSkills
from probe.errors import Unsatisfiable
from probe.perception.oracle import Oracle
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.sampling import PileSettings
from probe.scene.setup import UR5_TABLE
from probe.station.simulated import SimulatedStation
from probe.toolshed.toolshed import Toolshed
from probe.world.scenes import make_scene
from probe.world.world import World

DENSE = PileSettings(reach=0.12, buried=4)
ERRORS = (
    ("basket_unsaid", "in_basket", "in the basket and not said so"),
    ("unmentioned", "moved", "others moved or gone, unmentioned"),
    ("wrongly_unseen", "called_unseen", "wrongly called not to be seen"),
    ("mixed_up", "placed", "given the place of another"),
    ("wrongly_turned", "turned", "called turned or tipped, and not"),
    ("misjudged", "ways", "said to have gone further or less far than it did"),
)
"""Kinds of errors: what lists them, what counts the claims, and in words."""
out = Console()


def table_now(station: SimulatedStation, names: dict[int, str]) -> Table:
    """How things really stand."""
    labels = station.observe(rgb=False).labels
    inside = station.look_into_basket(rgb=False).labels
    assert labels is not None and inside is not None
    counts = dict(enumerate(np.bincount(inside.ravel()).tolist()))
    return Table(station.snapshot(), labels, counts, names)


def episode(
    seed: int,
    pool: Literal["procedural", "scans"],
    things: Library,
    renderer: Renderer,
    most: int,
    pictures: Path | None = None,
) -> Iterable[Verdict]:
    """Manipulations of one fresh scene; pictures of what was wrong go into a folder."""
    dense = seed % 2 == 1
    tables = tables_for(pool)
    scene = make_scene(seed, things, tables, pile=DENSE if dense else PileSettings())
    load_scene(renderer, scene, things, things.table(scene.table))
    station = SimulatedStation(World(scene, things), renderer)
    specs = {item.instance: things[item.object_id] for item in scene.objects}
    names = {number: spec.name for number, spec in specs.items()}
    tools = Toolshed(station, Oracle(specs), ArmSkills(), UR5_TABLE, pictures=False)
    rng = np.random.default_rng(seed)
    for number in range(most):
        old = table_now(station, names)
        before = station.observe(rgb=True) if pictures else None
        seen = read_graph(tools.call("perceive_scene", {}).text).objects
        place = seen[int(rng.integers(len(seen)))].place
        found = tools.call("find_object", {"description": place})
        name = read_handle(found.text)
        if name is None or found.point_px is None:
            continue
        u, v = found.point_px
        target = int(old.labels[v, u])
        tool, result = _act(tools, name, rng)
        verdict = judge(seed, pool, dense, tool, result, target, old, table_now(station, names))
        if pictures and before:
            keep(pictures, verdict, Moments(before, station.observe(rgb=True), names), number)
        yield verdict


def _act(tools: Toolshed, name: str, rng: np.random.Generator) -> tuple[str, str]:
    if rng.random() < 0.7:
        return "grasp", tools.call("grasp_and_remove", {"object_id": name}).text
    direction = ("up", "down", "left", "right")[int(rng.integers(4))]
    distance = round(float(rng.uniform(3, 20)), 1)
    arguments = {"object_id": name, "direction": direction, "distance_cm": distance}
    return "push", tools.call("push", arguments).text


def share(bad: int, of: int) -> str:
    if of == 0:
        return "none to judge"
    found = binomtest(bad, of).proportion_ci(method="wilson")
    return f"{bad} of {of}, {bad / of:.1%} ({found.low:.1%} to {found.high:.1%})"


def summary(lines: list[dict[str, Any]]) -> None:
    """Print the rates with 95 % intervals, and each error."""
    done = sum(line["done"] for line in lines)
    out.print(f"{len(lines)} manipulations, {sum(line['dense'] for line in lines)} in dense piles")
    out.print(f"false Done: {share(sum(line['false_done'] for line in lines), done)}")
    for errors, of, words in ERRORS:
        bad = sum(len(line[errors]) for line in lines)
        out.print(f"{words}: {share(bad, sum(line[of] for line in lines))}")
    for line in lines:
        found = {key: line[key] for key, *_ in ERRORS if line[key]}
        if found or line["false_done"]:
            out.print(
                f"seed {line['seed']} {line['tool']} {line['target']}: {found} {line['text']}"
            )


def main(
    pool: Literal["procedural", "scans"] = "procedural",
    first: int = 910_000,
    scenes: int = 20,
    most: int = 5,
    file: Path = Path("outputs/outcomes.jsonl"),
    pictures: Path | None = None,
) -> None:
    """Act on scenes that the file lacks, then print the rates of all that it holds.

    Args:
        pool: Where objects come from; scans need PROBE_ASSETS.
        first: Seed of the first scene.
        scenes: How many.
        most: Manipulations in each.
        file: Where results are kept.
        pictures: Folder for a picture of each reply that was wrong.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    kept = [json.loads(text) for text in file.read_text().splitlines()] if file.exists() else []
    have = {(line["pool"], line["seed"]) for line in kept}
    things = library(pool)
    with Renderer(things.light_cache) as renderer:
        for seed in track(range(first, first + scenes), "Scenes", console=out):
            if (pool, seed) in have:
                continue
            try:
                verdicts = list(episode(seed, pool, things, renderer, most, pictures))
            except Unsatisfiable as error:
                out.print(f"seed {seed} left out: {error}")
                continue
            with file.open("a") as lines:
                lines.writelines(json.dumps(verdict.line()) + "\n" for verdict in verdicts)
            kept += [verdict.line() for verdict in verdicts]
    summary(kept)
    out.print(f"all results: {file}")


if __name__ == "__main__":
    tyro.cli(main)
