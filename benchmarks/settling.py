"""How often and how fast 15 scans settle: `python benchmarks/settling.py [SEEDS]`.

Needs PROBE_ASSETS. Each scene is rebuilt from its poses and stepped for 2 s with the engine's
sleeping off; nothing may move further than 1 mm.
"""

from __future__ import annotations

import sys
import time

import mujoco
import numpy as np

from probe.assets.tables import table_ids
from probe.cli.surroundings import assets_folder, library
from probe.scene.scene import Scene
from probe.world.model import Item, add_item, new_spec
from probe.world.scenes import make_scene

REST_LIMIT = 0.001


def movement_and_depth(scene: Scene, things) -> tuple[float, float]:
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


def main(count: int) -> None:
    """Print one line a seed and the summary."""
    things, tables = library("scans"), table_ids(assets_folder())
    for spec in things.specs:
        things.body(spec.id)
    good, seconds = 0, []
    for seed in range(count):
        start = time.process_time()
        scene = make_scene(seed, things, tables)
        seconds.append(time.process_time() - start)
        moved, depth = movement_and_depth(scene, things)
        on_table = sum(placed.pose.position[2] > -0.01 for placed in scene.objects)
        rests = moved <= REST_LIMIT and on_table == len(scene.objects)
        good += rests
        print(
            f"seed {seed:3d}: {on_table} of {len(scene.objects)} on the table, "
            f"moved {1000 * moved:.2f} mm, overlap {1000 * depth:.2f} mm, {seconds[-1]:.2f} CPU s",
            flush=True,
        )
    print(
        f"{good} of {count} at rest with all objects on the table ({good / count:.0%}); "
        f"CPU s median {np.median(seconds):.2f}, p95 {np.percentile(seconds, 95):.2f}, "
        f"most {max(seconds):.2f}"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
