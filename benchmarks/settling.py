"""How often and how fast 15 objects settle, and how much of them then shows.

`python benchmarks/settling.py [--seeds 40] [--pool scans] [--reach 0.17] [--buried 0]`; scans need
PROBE_ASSETS. Each scene is rebuilt from its poses and stepped for 2 s with the engine's sleeping
off; nothing may move further than 1 mm.
"""

from __future__ import annotations

import time

import mujoco
import numpy as np
import tyro

from probe.assets.library import Library
from probe.assets.tables import load_table, table_ids
from probe.cli.surroundings import Pool, assets_folder, library
from probe.errors import Unsatisfiable
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.sampling import TIGHT, Pile
from probe.scene.scene import Scene
from probe.world.model import Item, add_item, new_spec
from probe.world.pile import SINK_LIMIT
from probe.world.scenes import make_scene

REST_LIMIT = 0.001


def movement_and_depth(scene: Scene, things: Library) -> tuple[float, float]:
    """Furthest way of any object's origin in 2 s, and deepest contact, both in metres."""
    spec = new_spec()
    for placed in scene.objects:
        body = things.body(placed.object_id)
        add_item(spec, Item(placed.instance, things[placed.object_id], body))
        spec.body(f"object/{placed.instance}").pos = placed.pose.position
        spec.body(f"object/{placed.instance}").quat = placed.pose.wxyz
    model = spec.compile()
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    before = data.qpos.reshape(-1, 7)[:, :3].copy()
    mujoco.mj_step(model, data, round(2.0 / model.opt.timestep))
    moved = np.linalg.norm(data.qpos.reshape(-1, 7)[:, :3] - before, axis=1).max()
    return float(moved), float(-data.contact.dist.min(initial=0.0))


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


def main(
    seeds: int = 40,
    first_seed: int = 0,
    pool: Pool = "scans",
    reach: float = TIGHT.reach,
    buried: int = TIGHT.buried,
) -> None:
    """Print one line a seed and the summary.

    Args:
        seeds: How many.
        first_seed: The first of them.
        pool: Which objects.
        reach: As in `probe scene`.
        buried: As in `probe scene`.
    """
    things, tables = library(pool), table_ids(assets_folder())
    if pool == "scans":  # else made on demand, and kept
        for spec in things.specs:
            things.body(spec.id)
    good, seconds, covered, hidden = 0, [], [], []
    with Renderer() as renderer:
        for seed in range(first_seed, first_seed + seeds):
            start = time.process_time()
            try:
                scene = make_scene(seed, things, tables, pile=Pile(reach, buried))
            except Unsatisfiable as failure:
                print(failure, flush=True)
                continue
            seconds.append(time.process_time() - start)
            moved, depth = movement_and_depth(scene, things)
            on_table = on_the_table(scene, things)
            good += moved <= REST_LIMIT and on_table == len(scene.objects)
            shares = seen_shares(scene, things, renderer)
            covered.append(int((shares < 0.5).sum()))
            hidden.append(int((shares <= 0.05).sum()))
            print(
                f"seed {seed:3d}: {on_table} of {len(scene.objects)} on the table, "
                f"moved {1000 * moved:.2f} mm, overlap {1000 * depth:.2f} mm, "
                f"{seconds[-1]:.2f} CPU s, {covered[-1]} under half seen, {hidden[-1]} hidden",
                flush=True,
            )
    print(
        f"{pool}, reach {reach} m, {buried} buried: "
        f"{good} of {seeds} at rest with all objects on the table ({good / seeds:.0%}); "
        f"CPU s median {np.median(seconds):.2f}, p95 {np.percentile(seconds, 95):.2f}, "
        f"most {max(seconds):.2f}; {np.mean(covered):.1f} a scene under half seen, one hidden in "
        f"{np.mean(np.array(hidden) > 0):.0%} of scenes ({np.mean(hidden):.2f} a scene)"
    )


if __name__ == "__main__":
    tyro.cli(main)
