"""Whether tables stay sound whatever is done to them.

`python benchmarks/internals/soundness.py --help`. Measures internals, not the public API.

Needs PROBE_ASSETS. A random agent's grasps and pushes on fresh scenes of 15 scans. After each of
them every object must be somewhere finite, at rest, not sunk into what it lies on, and on the
table, in the basket or on the floor; and a grasp may only claim what the basket holds.
"""

from __future__ import annotations

import mujoco
import numpy as np
import tyro
from rich.console import Console
from rich.progress import Progress

from probe import manipulation
from probe.agents.reading import read_graph, read_handle
from probe.api.resources import assets_folder, library
from probe.assets.library import Library
from probe.assets.tables import load_table, table_ids
from probe.perception.oracle import Oracle
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import FLOOR_DEPTH, UR5_TABLE
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import whereabouts
from probe.toolshed.toolshed import MANIPULATIONS, Toolshed
from probe.types import Array
from probe.world.model import Item, add_item, new_spec
from probe.world.scenes import make_scene
from probe.world.world import World

SUNK = 0.003
FURTHEST = 5.0
out = Console()


def lowest(placed: PlacedObject, things: Library) -> Array:
    """The lowest corner of its collision pieces, shape (3,)."""
    pieces = [piece.vertices for piece in things.body(placed.object_id).pieces]
    corners = placed.pose.apply(np.concatenate(pieces))
    return corners[corners[:, 2].argmin()]


def complaints(scene: Scene, things: Library) -> list[str]:
    """What is wrong with a table, in words."""
    found: list[str] = []
    for placed in scene.objects:
        where = np.array([*placed.pose.position, *placed.pose.wxyz])
        if not np.isfinite(where).all() or np.abs(where[:3]).max() > FURTHEST:
            found.append(f"{placed.object_id} is at {placed.pose.position}")
            continue
        x, y, z = lowest(placed, things)
        over_table = abs(x) < UR5_TABLE.table_size[0] / 2 and abs(y) < UR5_TABLE.table_size[1] / 2
        ground = 0.0 if over_table else -FLOOR_DEPTH
        if z < ground - SUNK:
            found.append(f"{placed.object_id} sinks {1000 * (ground - z):.1f} mm")
    depth = overlap(scene, things)
    if depth > SUNK:
        found.append(f"two objects overlap by {1000 * depth:.1f} mm")
    return found


def overlap(scene: Scene, things: Library) -> float:
    """Deepest contact between two objects, metres, on a model made of the poses alone."""
    spec = new_spec(UR5_TABLE.table_size)
    for placed in scene.objects:
        item = Item(placed.instance, things[placed.object_id], things.body(placed.object_id))
        body = add_item(spec, item)
        body.pos, body.quat = placed.pose.position, placed.pose.wxyz
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return max(0.0, -float(data.contact.dist.min(initial=0.0)))


def acts(tools: Toolshed, rng: np.random.Generator) -> tuple[str, str] | None:
    """Grasp or push something that shows; the tool and its reply, None if nothing is found."""
    seen = read_graph(tools.call("perceive_scene", {}).text).objects
    if not seen:
        return None
    place = seen[int(rng.integers(len(seen)))].place
    handle = read_handle(tools.call("find_object", {"description": place}).text)
    if handle is None:
        return None
    if rng.integers(2):
        return "grasp", tools.call("grasp_and_remove", {"object_id": handle}).text
    direction = ("up", "down", "left", "right")[int(rng.integers(4))]
    distance = round(float(rng.uniform(3, 20)), 1)
    arguments = {"object_id": handle, "direction": direction, "distance_cm": distance}
    return "push", tools.call("push", arguments).text


def main(actions: int = 200, first_seed: int = 61_000) -> None:
    """Print every complaint and the counts.

    Args:
        actions: Grasps and pushes in all, at most ten a scene.
        first_seed: Of the first scene.
    """
    things, tables = library("scans"), table_ids(assets_folder())
    done = wrong = false = off = 0
    with Renderer() as renderer, Progress(console=out) as bar:
        task = bar.add_task("Acting", total=actions)
        for seed in range(first_seed, first_seed + actions):
            scene = make_scene(seed, things, tables)
            load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
            station = SimulatedStation(World(scene, things), renderer)
            words = {item.instance: things[item.object_id] for item in scene.objects}
            tools = Toolshed(station, Oracle(words), manipulation, UR5_TABLE, pictures=False)
            rng, held = np.random.default_rng(seed), 0
            for _ in range(min(MANIPULATIONS, actions - done)):
                act = acts(tools, rng)
                if act is None:
                    break
                done += 1
                bar.advance(task)
                after = station.snapshot()
                for complaint in complaints(after, things):
                    wrong += 1
                    out.print(f"seed {seed}, {act}: {complaint}")
                now = sum(
                    whereabouts(placed.pose, UR5_TABLE) == "basket" for placed in after.objects
                )
                if act[0] == "grasp" and act[1].startswith("Done") and now == held:
                    false += 1
                    out.print(f"seed {seed}: a grasp claims what the basket doesn't hold")
                held = now
            off += sum(placed.pose.position[2] < -SUNK for placed in station.snapshot().objects)
            if done >= actions:
                break
    out.print(
        f"{done} actions: {wrong} complaints, {false} false claims; "
        f"{off} objects ended on the floor"
    )


if __name__ == "__main__":
    tyro.cli(main)
