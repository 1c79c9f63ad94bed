"""Whether flat and wide things are removed: `python benchmarks/internals/wide_things.py --help`.

Measures internals, not the public API.

What is tried: things of a suite's scenes that need over 10 cm for any level grasp across them and
are flat, or hollow with their mouth down, without a knob or a handle. Each is tried twice from the
same table: by the planner of ordinary grasps alone, and by all planners.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Sequence
from importlib import resources
from pathlib import Path
from typing import Literal

import numpy as np
import tyro
from pydantic import BaseModel, ConfigDict
from scipy.spatial import Delaunay
from scipy.stats import binomtest

from probe.api.resources import everything
from probe.assets.library import Library
from probe.manipulation.candidates import Planner, propose
from probe.manipulation.edges import smallest_width
from probe.manipulation.grasp import PLANNERS, grasp_and_remove
from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.seeds import generator
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import whereabouts
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.types import Array, Frame, Shard
from probe.world.world import World

Kind = Literal["slab", "cover"]
Hands = Literal["ordinary", "all"]

WIDE = 0.10
"""Metres that the smallest level grasp needs, at least."""

DRAGGED = 0.03
"""Metres along the table from which on what lay beneath counts as dragged along."""

PLAIN = (
    *("board", "book", "bowl", "box", "envelope", "frisbee", "magazine", "notebook", "paperback"),
    *("plate", "pot", "tin", "tray", "trivet"),
)
"""Last words of the categories whose things have neither knob nor handle."""

_FLAT = 0.05
_BENEATH = 0.2
_WHOLE = 0.95
_HANDS: dict[Hands, tuple[Planner, ...]] = {"ordinary": (propose,), "all": PLANNERS}


class Attempt(BaseModel):
    """One attempt; times in CPU seconds of this process, render worker not included.

    Attributes:
        kind: "slab" for flat things, "cover" for hollow ones with their mouth down.
        share: Visible share of the thing beforehand.
        beneath: How many things lay beneath it.
        dragged: How many of these went further than DRAGGED along the table.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    task: str
    instance: int
    hands: Hands
    object_id: str
    kind: Kind
    share: float
    removed: bool
    status: str
    tries: int
    width: float
    tilt: float
    beneath: int
    dragged: int
    seconds: float


def main(
    out: Path,
    suite: Path | None = None,
    scenes: int = 150,
    each: int = 1,
    hands: tuple[Hands, ...] = ("ordinary", "all"),
    number: int = 0,
    count: int = 1,
) -> None:
    """Try what is missing in a file of attempts, and print the rates.

    Args:
        out: A file of attempts, a JSON object a line. What is in it isn't tried again.
        suite: A suite's file; v1 if none is given. Build one for fresh scenes.
        scenes: How many of its scenes to draw things from.
        each: Things of a scene that are tried, at most.
        hands: Which to try.
        number: Of this shard.
        count: Of all shards; give each a file of its own.
    """
    with resources.as_file(resources.files("probe.tasks") / "data/v1.json") as v1:
        tasks = read_suite(suite or v1).tasks
    order = generator(0, "wide things").permutation(len(tasks))[:scenes]
    chosen = Shard(number, count).of([tasks[int(k)] for k in order])
    done = _read(out)
    things = everything()
    with Renderer(things.light_cache) as renderer, out.open("a") as file:
        for task in chosen:
            known = [row for row in done if row.task == task.id]
            for row in attempts(task, things, renderer, each, hands, known):
                file.write(row.model_dump_json() + "\n")
                file.flush()
                done.append(row)
    print("\n".join(table(done)))


def attempts(
    task: Task,
    things: Library,
    renderer: Renderer,
    each: int,
    hands: Sequence[Hands],
    known: Sequence[Attempt],
) -> Iterator[Attempt]:
    """The attempts that are missing on the first wide things of a scene, in its seed's order."""
    scene = task.scene
    shuffled = generator(task.seed, "wide things").permutation(len(scene.objects))
    ordered = [scene.objects[int(k)] for k in shuffled]
    wide: dict[PlacedObject, Kind] = {
        placed: kind for placed in ordered if (kind := kind_of(placed, things))
    }
    done = {(row.instance, row.hands) for row in known}
    tried = {row.instance for row in known}
    if not wide or (len(tried) >= each and all((i, h) in done for i in tried for h in hands)):
        return
    load_scene(renderer, scene, things, things.table(scene.table))
    world = World(scene, things)
    start = world.save()
    frame = SimulatedStation(world, renderer, task.viewpoint.camera).observe(rgb=False)
    for placed in [placed for placed in wide if shows(placed, frame)][:each]:
        for way in hands:
            if (placed.instance, way) in done:
                continue
            world.restore(start)
            station = SimulatedStation(world, renderer, task.viewpoint.camera)
            yield attempt(task, placed, wide[placed], way, station, frame, things)


def attempt(
    task: Task,
    placed: PlacedObject,
    kind: Kind,
    hands: Hands,
    station: SimulatedStation,
    frame: Frame,
    things: Library,
) -> Attempt:
    """One attempt at a table as it was made."""
    assert frame.labels is not None and frame.shares is not None
    scene, begun = task.scene, time.process_time()
    mask = frame.labels == placed.instance
    result = grasp_and_remove(station, frame, mask, scene.setup, _HANDS[hands])
    spent = time.process_time() - begun
    after = station.snapshot()
    below = lying_beneath(scene, placed, things)
    moved = [
        math.dist(one.pose.position[:2], after[one.instance].pose.position[:2]) for one in below
    ]
    return Attempt(
        task=task.id,
        instance=placed.instance,
        hands=hands,
        object_id=placed.object_id,
        kind=kind,
        share=frame.shares[placed.instance],
        removed=whereabouts(after[placed.instance].pose, scene.setup) == "basket",
        status=result.status,
        tries=result.tries,
        width=result.width,
        tilt=result.tilt,
        beneath=len(below),
        dragged=sum(way > DRAGGED for way in moved),
        seconds=spent,
    )


def shows(placed: PlacedObject, frame: Frame) -> bool:
    """Whether enough of it shows for the tools to name it."""
    assert frame.labels is not None and frame.shares is not None
    enough = frame.shares.get(placed.instance, 0.0) >= SEEN_SHARE
    return enough and bool(np.count_nonzero(frame.labels == placed.instance) >= SEEN_PX)


def kind_of(placed: PlacedObject, things: Library) -> Kind | None:
    """What kind of wide thing it is as it lies; None if it isn't any."""
    spec = things[placed.object_id]
    thin, narrow, _ = sorted(spec.size)
    turned_over = spec.hollow and placed.pose.rotation[2, 2] < -0.5
    plain = spec.category.rsplit(" ", 1)[-1] in PLAIN
    if not plain or narrow < WIDE or not (thin <= _FLAT or turned_over):
        return None
    if smallest_width(_corners(placed, things)[:, :2]) <= WIDE:
        return None
    return "cover" if turned_over else "slab"


def lying_beneath(scene: Scene, placed: PlacedObject, things: Library) -> list[PlacedObject]:
    """What has a fifth of its corners within a thing's outline, lower than its middle."""
    own = _corners(placed, things)
    outline = Delaunay(own[:, :2])
    found: list[PlacedObject] = []
    for other in scene.objects:
        corners = _corners(other, things)
        inside = outline.find_simplex(corners[:, :2]) >= 0
        lower = corners[:, 2].mean() < own[:, 2].mean()
        if other is not placed and lower and inside.mean() > _BENEATH:
            found.append(other)
    return found


def table(rows: Sequence[Attempt]) -> Iterator[str]:
    """Rates by kind and by category, in Markdown."""
    yield "| things | hands | removed | 95 % | something beneath dragged | CPU s |"
    yield "|---|---|---|---|---|---|"
    groups = {"all": lambda row: True, "shown whole": lambda row: row.share > _WHOLE}
    groups |= {kind: lambda row, kind=kind: row.kind == kind for kind in ("slab", "cover")}
    for word in sorted({_category(row) for row in rows}):
        groups[word] = lambda row, word=word: _category(row) == word
    for name, belongs in groups.items():
        for hands in _HANDS:
            some = [row for row in rows if belongs(row) and row.hands == hands]
            if not some:
                continue
            held = sum(row.removed for row in some)
            interval = binomtest(held, len(some)).proportion_ci(method="wilson")
            over = [row for row in some if row.beneath]
            dragged = sum(row.dragged > 0 for row in over)
            seconds = np.median([row.seconds for row in some])
            yield (
                f"| {name} | {hands} | {held} of {len(some)} | {interval.low:.0%} to "
                f"{interval.high:.0%} | {dragged} of {len(over)} | {seconds:.1f} |"
            )


def _category(row: Attempt) -> str:
    return row.object_id.rsplit("_", 1)[-1]


def _corners(placed: PlacedObject, things: Library) -> Array:
    return placed.pose.apply(things.body(placed.object_id).mesh.vertices)


def _read(path: Path) -> list[Attempt]:
    lines = path.read_text().splitlines() if path.exists() else []
    return [Attempt.model_validate_json(line) for line in lines]


if __name__ == "__main__":
    tyro.cli(main)
