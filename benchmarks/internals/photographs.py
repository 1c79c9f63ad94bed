"""Whether people can tell our pictures from others that stand in for photographs.

Measures internals, not the public API.

`python benchmarks/internals/photographs.py lay FOLDER` settles fresh tables and draws each with one
of two renderers: Filament, half of scans and half of objects made by formula, and Blender's EEVEE,
of scans alone, with so many samples that shadows show hardly any grain. Rooms, light and table tops
come from the same families for both, so that nothing but the renderer and the objects can tell.
Whoever sorts the pictures gets FOLDER/pictures and the counts; the key lies beside that folder.
Then `... score FOLDER ANSWERS.csv` counts what was told, from lines "number,filament" or
"number,blender". `--blender 0` draws ours alone, without Blender.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
import tyro
from rich.progress import track
from scipy.stats import binomtest
from tyro.conf import Positional

from probe.api.resources import library
from probe.assets.library import Library
from probe.assets.tabletops import tops
from probe.errors import Unsatisfiable
from probe.files import write_picture
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderers import Renderers
from probe.scene.cameras import View
from probe.scene.lighting import lighting_of
from probe.scene.scene import Scene
from probe.scene.setup import ROOM_TABLE, RendererName
from probe.world.scenes import make_scene

PoolName = Literal["procedural", "scans"]
VIEWS: tuple[View, ...] = ("front", "top")


@dataclass(frozen=True)
class Shot:
    """A picture to be drawn: of which objects, from where, by what."""

    renderer: RendererName
    pool: PoolName
    view: View


def shots(ours: int, others: int) -> list[Shot]:
    """As many from the front as from above, and as many of each kind of objects among ours."""
    pools: tuple[PoolName, ...] = ("scans", "procedural")
    made = [Shot("filament", pools[k % 2], VIEWS[k // 2 % 2]) for k in range(ours)]
    return made + [Shot("blender", "scans", VIEWS[k % 2]) for k in range(others)]


def settled(things: Library, seeds: Iterator[int]) -> Scene:
    """The next table that settles, with a top that is made by formula."""
    for seed in seeds:
        try:
            return make_scene(seed, things, tuple(tops()), setup=ROOM_TABLE)
        except Unsatisfiable:
            continue
    raise AssertionError("seeds don't end")


def lay(folder: Positional[Path], filament: int = 20, blender: int = 13, seed: int = 0) -> None:
    """Draw pictures in a drawn order, and write the key.

    Args:
        folder: For pictures/NN.png and key.csv.
        filament: How many of ours.
        blender: How many of the others; Blender takes a CPU minute for each.
        seed: Of the order; tables are made from 1000 times this on.
    """
    wanted = shots(filament, blender)
    order = np.random.default_rng(seed).permutation(len(wanted))
    seeds = iter(range(1000 * seed, 10**9))
    names: set[PoolName] = {shot.pool for shot in wanted}
    pools = {name: library(name) for name in names}
    rows: list[Sequence[object]] = []
    light_cache = next(iter(pools.values())).light_cache
    with Renderers(light_cache) as renderers:
        for number, k in enumerate(track(order, "Pictures"), start=1):
            shot, things = wanted[k], pools[wanted[k].pool]
            scene = settled(things, seeds)
            drawing = renderers[shot.renderer]
            load_scene(drawing, scene, things)
            lighting = lighting_of(scene.setup.lighting, scene.table)
            light = light_of(lighting, things.assets)
            camera = scene.setup.camera(shot.view)
            frame = photograph(drawing, scene, camera=camera, light=light, grainless=True)
            assert frame.rgb is not None
            write_picture(folder / "pictures" / f"{number:02d}.png", frame.rgb)
            rows.append((number, shot.renderer, shot.pool, shot.view, scene.seed, lighting.name))
    with (folder / "key.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows(rows)
    print(f"{filament} of ours and {blender} of the others are in {folder / 'pictures'}")


def score(folder: Positional[Path], answers: Positional[Path]) -> None:
    """Print how many were told, by renderer, objects and camera."""
    said = {int(number): name.strip() for number, name in _rows(answers)}
    groups: dict[str, list[bool]] = {}
    for number, renderer, pool, view, *_ in _rows(folder / "key.csv"):
        right = said.get(int(number)) == renderer
        for group in ("all", f"{renderer}, {pool}", view):
            groups.setdefault(group, []).append(right)
    for group, told in groups.items():
        low, high = binomtest(sum(told), len(told)).proportion_ci(method="wilson")
        print(f"{group}: {sum(told)} of {len(told)} ({100 * low:.0f} to {100 * high:.0f} %)")


def _rows(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


if __name__ == "__main__":
    tyro.extras.subcommand_cli_from_dict({"lay": lay, "score": score})
