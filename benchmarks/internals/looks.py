"""Time of pictures by light and camera, and of what they need.

`python benchmarks/internals/looks.py`. Measures internals, not the public API.

Uses real scans with PROBE_ASSETS, else procedural objects; the lights are painted rooms.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from probe.api.resources import assets_folder, library
from probe.assets.environments import load_environment
from probe.assets.tables import load_table, table_ids
from probe.assets.tabletops import tops
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.render.sunlight import illuminate
from probe.scene.cameras import View
from probe.scene.lighting import AMBIENT, Lighting, hdri
from probe.scene.setup import UR5_TABLE, RendererName
from probe.world.scenes import make_scene

REPEATS = 7
ROOM = "morning_kitchen"
VIEWS: tuple[View, ...] = ("top", "front")
LIGHTS: tuple[Lighting, ...] = (AMBIENT, hdri(ROOM), Lighting("day_room_9"))


def seconds(act: Callable[[], object], repeats: int = REPEATS) -> float:
    """Median wall time of an action."""
    taken: list[float] = []
    for _ in range(repeats):
        start = time.perf_counter()
        act()
        taken.append(time.perf_counter() - start)
    return float(np.median(taken))


def pictures(engine: RendererName, repeats: int) -> None:
    """Print the time of a picture with depth and labels, by light and camera."""
    pool = "scans" if assets_folder() else "procedural"
    things = library(pool)
    scene = make_scene(0, things, table_ids(assets_folder()))
    with tempfile.TemporaryDirectory() as folder, Renderer(Path(folder), engine) as renderer:
        load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
        print(f"{engine}: 15 {pool} objects, 1024 x 1024, {os.cpu_count()} cores, n {repeats}:")
        for lighting in LIGHTS:
            light = light_of(lighting, None)
            for view in VIEWS:
                camera = UR5_TABLE.camera(view)

                def draw() -> object:
                    return photograph(renderer, scene, camera=camera, light=light)  # noqa: B023

                first = seconds(draw, 1)
                later = seconds(draw, repeats)
                print(f"  {lighting.name:16} {view:6} {later:.2f} s (first {first:.2f})")


def preparations() -> None:
    """Print the time of painting a room and a table, and of making light of a panorama."""
    panorama = load_environment(ROOM, None)
    load_environment.cache_clear()
    print("Once for each, wall seconds")
    print(f"  painting a room       {seconds(lambda: load_environment(ROOM, None), 1):.2f}")
    print(f"  sun and exposure      {seconds(lambda: illuminate(panorama, 0.0)):.2f}")
    day_room = Lighting("day_room_9")
    print(f"  a day room, all that  {seconds(lambda: light_of(day_room, None), 1):.2f}")
    kinds = {type(top): id for id, top in tops().items()}.values()
    taken = [seconds(lambda id=id: load_table(id, None), 1) for id in kinds]
    print(f"  painting a table      {np.median(taken):.2f} (most {max(taken):.2f})")


if __name__ == "__main__":
    pictures("filament", REPEATS)
    if find_spec("bpy"):
        pictures("blender", 2)
    preparations()
