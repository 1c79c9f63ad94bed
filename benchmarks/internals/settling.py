"""How often and how fast 15 objects settle, whether they stay, and how much of them then shows.

Measures internals, not the public API.

`python benchmarks/internals/settling.py [--seeds 200] [--pool scans] [--reach 0.17] [--buried 0]`;
scans need PROBE_ASSETS. Each scene is built anew as an episode builds it, robot included, and
stepped for 2 s with the engine's sleeping off; no corner of anything may move further than 1 mm.

May be interrupted and run again; `--shard 0/2` and `--shard 1/2` share the work, and whoever runs
it once more with the same settings reads all that is there.
"""

from __future__ import annotations

import time
from pathlib import Path

import probe  # before NumPy: sums are then the same everywhere, and so are scenes

# isort: split
import mujoco
import numpy as np
import pydantic
import tyro

from probe.api.resources import Pool, assets_folder, library
from probe.assets.library import Library
from probe.assets.tables import load_table, table_ids
from probe.cli.shards import parse_shard
from probe.errors import Unsatisfiable
from probe.files import claim_folder
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.sampling import TIGHT, PileSettings
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.types import Array, Pose
from probe.world.model import TIME_STEP, Item, build_cell
from probe.world.pile import SINK_LIMIT
from probe.world.robot.robot import arm_joints
from probe.world.scenes import draw_scene

REST_TIME, REST_LIMIT = 2.0, 0.001


class Settings(pydantic.BaseModel, frozen=True, extra="forbid"):
    """What all lines of a folder have in common."""

    pool: str
    first_seed: int
    reach: float
    buried: int
    shares: bool


class Line(pydantic.BaseModel, frozen=True, extra="forbid"):
    """One seed; what is None wasn't measured.

    Attributes:
        failure: Why it has no scene.
        seconds: CPU time of drawing and settling it.
        restless: Draws before it that settled, but moved on a table built anew.
        on_table, things: Objects that are on the table, and all.
        moved, depth: Furthest way of any corner in REST_TIME, deepest contact, metres.
        under_half, hidden: Objects of which less than 50 % shows, and at most 5 %.
    """

    seed: int
    failure: str = ""
    seconds: float = 0.0
    restless: int = 0
    on_table: int = 0
    things: int = 0
    moved: float = 0.0
    depth: float = 0.0
    under_half: int | None = None
    hidden: int | None = None

    @property
    def good(self) -> bool:
        """Whether it has a scene, at rest, with everything on the table."""
        return not self.failure and self.moved <= REST_LIMIT and self.on_table == self.things


def movement_and_depth(scene: Scene, things: Library) -> tuple[float, float]:
    """Furthest way of any corner in REST_TIME on a fresh table, and deepest contact, metres."""
    bodies = {placed.instance: things.body(placed.object_id) for placed in scene.objects}
    items = [Item(o.instance, things[o.object_id], bodies[o.instance]) for o in scene.objects]
    model = build_cell(items, {o.instance: o.pose for o in scene.objects})
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    for name, angle in zip(arm_joints("ur5"), UR5_TABLE.mount.parked, strict=True):
        data.joint(name).qpos[0] = data.actuator(name).ctrl[0] = angle
    corners = {n: np.concatenate([p.vertices for p in body.pieces]) for n, body in bodies.items()}

    def where() -> dict[int, Array]:
        states = {n: data.joint(f"object/{n}").qpos for n in corners}
        return {n: Pose.of(q[:3], q[3:]).apply(corners[n]) for n, q in states.items()}

    before = where()
    mujoco.mj_step(model, data, round(REST_TIME / TIME_STEP))
    after = where()
    moved = max(float(np.linalg.norm(after[n] - before[n], axis=1).max()) for n in before)
    return moved, float(-data.contact.dist.min(initial=0.0))


def on_the_table(scene: Scene, things: Library) -> int:
    """How many objects have no corner further below the table's top than they may sink."""
    lowest = (
        min(placed.pose.apply(piece.vertices)[:, 2].min() for piece in body.pieces)
        for placed in scene.objects
        for body in [things.body(placed.object_id)]
    )
    return sum(bool(z > -SINK_LIMIT) for z in lowest)


def seen_shares(scene: Scene, things: Library, renderer: Renderer) -> np.ndarray:
    """Visible share of each object from above."""
    load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
    return np.array([seen.fraction for seen in measure(renderer, scene).values()])


def measured(seed: int, settings: Settings, things: Library, renderer: Renderer | None) -> Line:
    """All figures of one seed."""
    tables, pile = table_ids(assets_folder()), PileSettings(settings.reach, settings.buried)
    start = time.process_time()
    try:
        drawn = draw_scene(seed, things, tables, pile=pile)
    except Unsatisfiable as failure:
        return Line(seed=seed, failure=str(failure))
    seconds = time.process_time() - start
    moved, depth = movement_and_depth(drawn.scene, things)
    shares = None if renderer is None else seen_shares(drawn.scene, things, renderer)
    return Line(
        seed=seed,
        seconds=seconds,
        restless=drawn.restless,
        on_table=on_the_table(drawn.scene, things),
        things=len(drawn.scene.objects),
        moved=moved,
        depth=depth,
        under_half=None if shares is None else int((shares < 0.5).sum()),
        hidden=None if shares is None else int((shares <= 0.05).sum()),
    )


def read(out: Path) -> dict[int, Line]:
    """All lines of a folder by seed."""
    texts = (text for file in sorted(out.glob("*.jsonl")) for text in file.read_text().splitlines())
    lines = [Line.model_validate_json(text) for text in texts]
    return {line.seed: line for line in sorted(lines, key=lambda line: line.seed)}


def main(
    seeds: int = 40,
    first_seed: int = 0,
    pool: Pool = "scans",
    reach: float = TIGHT.reach,
    buried: int = TIGHT.buried,
    shares: bool = True,
    shard: str = "0/1",
    out: Path | None = None,
) -> None:
    """Print one line a seed and the summary of all that is there.

    Args:
        seeds: How many.
        first_seed: The first of them.
        pool: Which objects.
        reach: As in `probe scene`.
        buried: As in `probe scene`.
        shares: Whether to measure how much of the objects shows; needs a graphics driver.
        shard: "0/2" and "1/2" in two processes share the work.
        out: Folder for the lines; by default one in outputs/settling for these settings.
    """
    named = f"{pool}-{first_seed}-{reach}-{buried}{'' if shares else '-rest'}"
    out, part = out or Path("outputs/settling") / named, parse_shard(shard)
    settings = Settings(pool=pool, first_seed=first_seed, reach=reach, buried=buried, shares=shares)
    claim_folder(out / "settings.json", settings, "Choose another folder.")
    things, done = library(pool), read(out)
    wanted = range(first_seed, first_seed + seeds)
    mine = [seed for seed in part.of(wanted) if seed not in done]
    # So that no scene's time has it; procedural ones are made on demand, and kept.
    for spec in things.specs if mine and pool != "procedural" else ():
        things.form(spec.id)
    with Renderer() as renderer, (out / f"{part.number}-of-{part.count}.jsonl").open("a") as file:
        for seed in mine:
            line = measured(seed, settings, things, renderer if shares else None)
            print(line.model_dump_json(), file=file, flush=True)
            print(told(line), flush=True)
    summarise(settings, [line for seed, line in read(out).items() if seed in wanted])


def told(line: Line) -> str:
    """A line for people."""
    if line.failure:
        return line.failure
    seen = (
        "" if line.hidden is None else f", {line.under_half} under half seen, {line.hidden} hidden"
    )
    again = f", drawn anew {line.restless} times" if line.restless else ""
    return (
        f"seed {line.seed:3d}: {line.on_table} of {line.things} on the table, "
        f"moved {1000 * line.moved:.2f} mm, overlap {1000 * line.depth:.2f} mm, "
        f"{line.seconds:.2f} CPU s{seen}{again}"
    )


def summarise(settings: Settings, lines: list[Line]) -> None:
    """Print the figures of all seeds."""
    made = [line for line in lines if not line.failure]
    seconds = [line.seconds for line in made]
    good, again = sum(line.good for line in made), sum(line.restless > 0 for line in made)
    print(
        f"probe {probe.__version__}: {settings.pool}, reach {settings.reach} m, "
        f"{settings.buried} buried: "
        f"of {len(lines)} seeds {len(made)} have a scene; "
        f"{good} at rest with all objects on the table ({good / len(made):.1%}); "
        f"{again} drawn anew ({again / len(made):.1%}); "
        f"CPU s median {np.median(seconds):.2f}, p95 {np.percentile(seconds, 95):.2f}, "
        f"most {max(seconds):.2f}"
    )
    if settings.shares:
        hidden = np.array([line.hidden or 0 for line in made])
        print(
            f"{np.mean([line.under_half or 0 for line in made]):.1f} a scene under half seen, "
            f"one hidden in {np.mean(hidden > 0):.0%} of scenes ({np.mean(hidden):.2f} a scene)"
        )


if __name__ == "__main__":
    tyro.cli(main)
