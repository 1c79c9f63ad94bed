"""Time and memory of observations: `python benchmarks/internals/observation.py [OBSERVATIONS]`.

Measures internals, not the public API.

Uses real scans with PROBE_ASSETS, else procedural objects. A bare frame is a later frame of a
context that has already drawn one: what Filament takes for the pixels alone.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable

import numpy as np
import psutil

from probe.api.resources import assets_folder, library
from probe.assets.library import Library
from probe.assets.tables import load_table, table_ids
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.world.scenes import make_scene

REPEATS = 7
SCENES = 20
EACH = 2


def seconds(act: Callable[[], object]) -> float:
    """Median wall time of an action after one warm-up."""
    act()
    taken: list[float] = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        act()
        taken.append(time.perf_counter() - start)
    return float(np.median(taken))


def bare_frame(scene: Scene, things: Library) -> float:
    """Seconds for one more RGB frame, in a child process that owns the context."""
    from probe.render.filament import Drawer
    from probe.render.illumination import AMBIENT
    from probe.render.light_packing import LightPacker
    from probe.render.packing import pack, table_quad
    from probe.render.protocol import TableTop

    table = load_table(scene.table, assets_folder())
    meshes = {o.object_id: pack(things.body(o.object_id).mesh) for o in scene.objects}
    top = pack(table_quad(TableTop(table.surface, table.tile_size, UR5_TABLE.table_size)))
    read, write = os.pipe()
    if os.fork() == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Filament reports its set-up on stdout
        drawer = Drawer(meshes, top, LightPacker().pack(AMBIENT))
        taken = seconds(lambda: drawer.rgb(scene.objects, UR5_TABLE.camera()))
        os.write(write, str(taken).encode())
        os._exit(0)
    os.close(write)
    os.wait()
    return float(os.read(read, 100))


def memory() -> float:
    """Megabytes that this process and all below it occupy, shared pages counted once."""
    me = psutil.Process()
    family = [me, *me.children(recursive=True)]
    return sum(process.memory_full_info().pss for process in family) / 1e6


def main(observations: int) -> None:
    """Print the table."""
    pool = "scans" if assets_folder() else "procedural"
    things, tables = library(pool), table_ids(assets_folder())
    scenes = [make_scene(seed, things, tables) for seed in range(SCENES)]
    bare = bare_frame(scenes[0], things)
    with Renderer() as renderer:
        load_scene(renderer, scenes[0], things, load_table(scenes[0].table, assets_folder()))
        whole = seconds(lambda: photograph(renderer, scenes[0]))
        labels = seconds(lambda: photograph(renderer, scenes[0], rgb=False))
        outlines = seconds(lambda: renderer.outlines(scenes[0].objects, UR5_TABLE.camera()))
        print(f"15 {pool} objects, 1024 x 1024, {os.cpu_count()} cores, wall seconds (ratio)")
        print(f"  bare Filament frame       {bare:.2f} (1.00)")
        print(f"  RGB + depth + labels      {whole:.2f} ({whole / bare:.2f})")
        print(f"  depth + labels            {labels:.2f} ({labels / bare:.2f})")
        print(f"  15 outlines               {outlines:.2f} ({outlines / bare:.2f})")
        passes = max(2, observations // (SCENES * EACH))
        used = [one_pass(renderer, scenes, things) for _ in range(passes)]
    print(f"Memory of all processes, MB, mean of {SCENES} scenes x {EACH} observations a pass")
    for number, mean in enumerate(used, start=1):
        print(f"  pass {number}  {mean:.0f} ({mean / used[0]:.2f})")


def one_pass(renderer: Renderer, scenes: list[Scene], things: Library) -> float:
    """Load every scene in turn and observe it; mean memory after an observation, MB.

    Scenes differ in the size of their textures, so that only whole passes compare.
    """
    used: list[float] = []
    for scene in scenes:
        load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
        for _ in range(EACH):
            photograph(renderer, scene)
            used.append(memory())
    return float(np.mean(used))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200)
