"""How often grasps and pushes work in clutter: `python benchmarks/skills.py --help`.

Needs PROBE_ASSETS. Scenes of 15 scans from fresh seeds; targets are drawn evenly from the objects
that are seen (30 % and 400 pixels), at most five a scene, each from the same restored state.
A grasp works if its object ends in the basket, by the simulator's truth. A push was executed if
the tool swept the distance asked for, less 1 cm at most. CPU seconds are those of
this process; the render worker's are not in them.
"""

from __future__ import annotations

import contextlib
import math
import time
from collections import Counter
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import tyro
from rich.console import Console
from rich.progress import Progress

from probe.assets.library import Library
from probe.assets.tables import load_table, table_ids
from probe.cli.surroundings import assets_folder, library
from probe.manipulation.grasp import grasp_and_remove
from probe.manipulation.push import LONGEST, SHORTEST, Direction, push
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.layout import BASKET_POSITION
from probe.scene.scene import PlacedObject, Scene
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import whereabouts
from probe.types import Array, Frame
from probe.world.scenes import make_scene
from probe.world.world import World

PER_SCENE = 5
SEEN_SHARE, SEEN_PX = 0.30, 400
MOVED = 0.03
FELL_SHORT = 0.01
ALONG: dict[Direction, tuple[int, int, int]] = {
    "left": (-1, 0, 0),
    "right": (1, 0, 0),
    "up": (0, 1, 0),
    "down": (0, -1, 0),
}
out = Console()


class Timed:
    """A Station that adds up the CPU seconds spent in it."""

    def __init__(self, station: SimulatedStation) -> None:
        self.arm, self.hand = station.arm, station.hand
        self.seconds = 0.0
        self._station = station

    def observe(self, *, rgb: bool) -> Frame:
        with self._clock():
            return self._station.observe(rgb=rgb)

    def joints(self) -> Array:
        return self._station.joints()

    def follow(self, path: Array) -> bool:
        with self._clock():
            return self._station.follow(path)

    def grip(self, opening: float) -> float:
        with self._clock():
            return self._station.grip(opening)

    def wait(self, seconds: float) -> None:
        with self._clock():
            self._station.wait(seconds)

    @contextlib.contextmanager
    def _clock(self) -> Generator[None]:
        start = time.process_time()
        yield
        self.seconds += time.process_time() - start


@dataclass(frozen=True, eq=False)
class Trial:
    """One target in one restored state."""

    seed: int
    target: PlacedObject
    frame: Frame
    station: Timed
    world: World
    rng: np.random.Generator

    @property
    def mask(self) -> Array:
        assert self.frame.labels is not None
        return self.frame.labels == self.target.instance

    @property
    def share(self) -> float:
        assert self.frame.shares is not None
        return self.frame.shares[self.target.instance]


@dataclass(frozen=True)
class Outcome:
    """What came of a trial; seconds are CPU seconds."""

    seed: int
    good: bool
    executed: bool
    cause: str
    groups: tuple[str, ...]
    others_moved: int
    planning: float
    execution: float
    ratio: float = 0.0


def trials(first_seed: int, count: int, renderer: Renderer, things: Library) -> Iterator[Trial]:
    tables = table_ids(assets_folder())
    seed = first_seed
    while count > 0:
        scene = make_scene(seed, things, tables)
        load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
        world = World(scene, things)
        frame = SimulatedStation(world, renderer).observe(rgb=False)
        start, rng = world.save(), np.random.default_rng(seed)
        for target in drawn(scene, frame, rng)[:count]:
            world.restore(start)
            station = Timed(SimulatedStation(world, renderer))
            yield Trial(seed, target, frame, station, world, rng)
            count -= 1
        seed += 1


def drawn(scene: Scene, frame: Frame, rng: np.random.Generator) -> list[PlacedObject]:
    assert frame.labels is not None and frame.shares is not None
    seen = [
        placed
        for placed in scene.objects
        if frame.shares.get(placed.instance, 0.0) >= SEEN_SHARE
        and np.count_nonzero(frame.labels == placed.instance) >= SEEN_PX
    ]
    return [seen[index] for index in rng.permutation(len(seen))[:PER_SCENE]]


def grasped(trial: Trial, things: Library) -> Outcome:
    before, start = trial.world.scene(), time.process_time()
    result = grasp_and_remove(trial.station, trial.frame, trial.mask, BASKET_POSITION)
    spent = time.process_time() - start
    after = trial.world.scene()
    inside = whereabouts(after[trial.target.instance].pose) == "basket"
    told = result.status == "removed"
    where = "in the basket" if inside else "not in the basket"
    cause = result.status if inside == told else f"{result.status} but {where}"
    spec = things[trial.target.object_id]
    groups = (
        f"longest side {band(max(spec.size), 0.08, 0.16)}",
        f"grasp width {band(result.width, 0.03, 0.06, 0.09)}" if result.tries else "no grasp",
        f"visible {'all' if trial.share > 0.95 else 'over 60 %' if trial.share > 0.6 else 'less'}",
        f"mass {'over' if spec.mass > 0.3 else 'up to'} 0.3 kg",
        f"tries {result.tries}",
    )
    moved = others_moved(before, after, trial.target)
    planning = spent - trial.station.seconds
    return Outcome(trial.seed, inside, told, cause, groups, moved, planning, trial.station.seconds)


def pushed(trial: Trial) -> Outcome:
    directions = list(ALONG)
    direction = directions[int(trial.rng.integers(len(directions)))]
    distance = float(trial.rng.uniform(SHORTEST, LONGEST))
    before, start = trial.world.scene(), time.process_time()
    result = push(trial.station, trial.frame, trial.mask, direction, distance, BASKET_POSITION)
    spent = time.process_time() - start
    after = trial.world.scene()
    number = trial.target.instance
    way = np.subtract(after[number].pose.position, before[number].pose.position)
    ratio = float(way @ np.array(ALONG[direction])) / distance
    moved = others_moved(before, after, trial.target)
    planning = spent - trial.station.seconds
    return Outcome(
        trial.seed,
        ratio >= 0.5,
        result.swept > distance - FELL_SHORT,
        result.status,
        (direction, f"asked {band(distance, 0.08, 0.14)}"),
        moved,
        planning,
        trial.station.seconds,
        ratio,
    )


def others_moved(before: Scene, after: Scene, target: PlacedObject) -> int:
    return sum(
        math.dist(placed.pose.position, after[placed.instance].pose.position) > MOVED
        for placed in before.objects
        if placed.instance != target.instance
    )


def band(value: float, *edges: float) -> str:
    above = [edge for edge in edges if value > edge]
    below = [edge for edge in edges if value <= edge]
    low = f"{100 * above[-1]:.0f}" if above else "0"
    return f"{low}-{100 * below[0]:.0f} cm" if below else f"over {low} cm"


def wilson(good: int, n: int) -> tuple[float, float]:
    """95 % score interval (E. B. Wilson, JASA 22, 1927)."""
    z, p = 1.96, good / n
    middle = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return middle - half, middle + half


def by_scene(seeds: Sequence[int], good: Sequence[bool]) -> tuple[float, float]:
    """95 % percentile interval of the bootstrap that draws whole scenes."""
    rng, groups = np.random.default_rng(0), sorted(set(seeds))
    wins = np.array([sum(g for s, g in zip(seeds, good, strict=True) if s == k) for k in groups])
    sizes = np.array([sum(s == k for s in seeds) for k in groups])
    draws = rng.integers(len(groups), size=(4000, len(groups)))
    rates = wins[draws].sum(axis=1) / sizes[draws].sum(axis=1)
    low, high = np.percentile(rates, [2.5, 97.5])
    return float(low), float(high)


def rate(name: str, outcomes: Sequence[Outcome], good: Sequence[bool]) -> None:
    n, wins = len(good), sum(good)
    low, high = wilson(wins, n)
    scene_low, scene_high = by_scene([o.seed for o in outcomes], good)
    out.print(
        f"{name}: {wins} of {n} = {wins / n:.1%} (Wilson {low:.0%}-{high:.0%}, "
        f"bootstrap by scene {scene_low:.0%}-{scene_high:.0%})"
    )


def summary(outcomes: Sequence[Outcome]) -> None:
    causes = Counter(o.cause for o in outcomes)
    out.print("  outcomes: " + ", ".join(f"{name} {n}" for name, n in causes.most_common()))
    groups = sorted({group for o in outcomes for group in o.groups})
    for group in groups:
        some = [o.good for o in outcomes if group in o.groups]
        out.print(f"  {group}: {sum(some)} of {len(some)}")
    moved = [o.others_moved for o in outcomes]
    out.print(
        f"  others moved over {100 * MOVED:.0f} cm: in {np.mean(np.array(moved) > 0):.0%} of "
        f"attempts, {np.mean(moved):.2f} a time"
    )
    for name, values in (
        ("planning", [o.planning for o in outcomes]),
        ("execution", [o.execution for o in outcomes]),
    ):
        p95 = np.percentile(values, 95)
        out.print(f"  {name} CPU s: median {np.median(values):.2f}, p95 {p95:.2f}")


def main(grasps: int = 100, pushes: int = 60, first_seed: int = 41_000) -> None:
    """Print success rates with intervals.

    Args:
        grasps: Attempts.
        pushes: Attempts; their scenes follow those of the grasps.
        first_seed: Of the first scene.
    """
    things = library("scans")
    with Renderer() as renderer, Progress(console=out) as bar:
        task = bar.add_task("Grasping", total=grasps)
        took: list[Outcome] = []
        for trial in trials(first_seed, grasps, renderer, things):
            took.append(grasped(trial, things))
            out.print(f"{trial.seed} {trial.target.object_id}: {took[-1].cause}")
            bar.advance(task)
        task = bar.add_task("Pushing", total=pushes)
        shoved: list[Outcome] = []
        for trial in trials(first_seed + 10_000, pushes, renderer, things):
            shoved.append(pushed(trial))
            last = shoved[-1]
            out.print(f"{trial.seed} {trial.target.object_id}: {last.cause}, {last.ratio:.2f}")
            bar.advance(task)
    if took:
        rate("grasp_and_remove in the basket", took, [o.good for o in took])
        summary(took)
    if shoved:
        rate("push executed", shoved, [o.executed for o in shoved])
        rate("push effective (half of the distance or more)", shoved, [o.good for o in shoved])
        summary(shoved)
        ratios = [o.ratio for o in shoved if o.executed]
        out.print(f"  way of the object over the distance asked, median {np.median(ratios):.2f}")


if __name__ == "__main__":
    tyro.cli(main)
