"""How often a real segmenter errs, as the rates that `Dials` takes.

`python benchmarks/internals/detector_errors.py --help`. Measures internals, not the public API.

Draws settled tables in the shadowed light of rooms and lets the RGB-D segmenter find things. A
mask belongs to whatever has most of its pixels. Of each object that is seen (30 % and 400 px):

- under: half of it lies in one mask that belongs to another object;
- over: two masks or more belong to it that each have a fifth of it;
- missed: neither, and the masks that belong to it have less than half of it.

hallucinated: masks that belong to the bare table, by seen objects. About 8 CPU seconds a table.
"""

from __future__ import annotations

from collections import Counter
from typing import Literal

import numpy as np
import tyro
from rich.progress import track
from scipy.stats import binomtest

from probe.api.resources import library, tables_for
from probe.errors import Unsatisfiable
from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.perception.segmenter import SMALLEST_PX, Segmenter
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.scene.lighting import lighting_of
from probe.scene.setup import ROOM_TABLE
from probe.types import Array
from probe.world.scenes import make_scene

RATES = ("over", "under", "missed", "hallucinated")
_HALF, _A_PART = 0.5, 0.2


def errors_of(numbers: Array, labels: Array, seen: tuple[int, ...]) -> Counter[str]:
    """Errors of one picture.

    Args:
        numbers: Which mask each pixel belongs to, 0 for none, shape (h, w).
        labels: Which instance it shows, 0 for the table, shape (h, w).
        seen: Instances that are judged.
    """
    shared = np.zeros((numbers.max() + 1, labels.max() + 1), dtype=int)
    np.add.at(shared, (numbers.ravel(), labels.ravel()), 1)
    sizes = shared.sum(axis=0)
    masks = [n for n in range(1, len(shared)) if shared[n].sum() >= SMALLEST_PX]
    owner = {n: int(shared[n].argmax()) for n in masks}
    found = Counter(hallucinated=sum(who == 0 for who in owner.values()))
    for one in seen:
        own = [shared[n, one] / sizes[one] for n in masks if owner[n] == one]
        of_others = [shared[n, one] / sizes[one] for n in masks if owner[n] != one]
        if max(of_others, default=0.0) >= _HALF:
            found["under"] += 1
        elif sum(share >= _A_PART for share in own) > 1:
            found["over"] += 1
        elif sum(own) < _HALF:
            found["missed"] += 1
    return found


def main(
    pool: Literal["evaluation", "scans"] = "evaluation", first: int = 980_000, scenes: int = 20
) -> None:
    """Print each rate with its 95 % interval.

    Args:
        pool: Where objects come from; scans need PROBE_ASSETS.
        first: Seed of the first table.
        scenes: How many tables.
    """
    things, tables, segmenter = library(pool), tables_for(pool), Segmenter()
    errors, judged = Counter[str](), 0
    with Renderer(things.light_cache) as renderer:
        for seed in track(range(first, first + scenes), "Tables"):
            try:
                scene = make_scene(seed, things, tables, setup=ROOM_TABLE)
            except Unsatisfiable as failure:
                print(f"seed {seed} left out: {failure}")
                continue
            load_scene(renderer, scene, things)
            lighting = lighting_of(scene.setup.lighting, scene.table)
            frame = photograph(renderer, scene, light=light_of(lighting, things.assets))
            shown = measure(renderer, scene)
            seen = tuple(
                instance
                for instance, share in shown.items()
                if share.fraction >= SEEN_SHARE and share.visible_px >= SEEN_PX
            )
            assert frame.labels is not None
            errors += errors_of(segmenter.numbers(frame), frame.labels, seen)
            judged += len(seen)
    print(f"{judged} seen objects on {scenes} tables")
    for name in RATES:
        # Of one object more than one thing may be made up; no interval says more than n then.
        low, high = binomtest(min(errors[name], judged), judged).proportion_ci(method="wilson")
        print(f"{name}: {errors[name]}, {errors[name] / judged:.1%} ({low:.1%} to {high:.1%})")


if __name__ == "__main__":
    tyro.cli(main)
