"""Pictures of settled scenes of scans, with what each pixel really shows kept apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from probe.api.resources import assets_folder, cache_folder, library
from probe.assets.tables import load_table, table_ids
from probe.errors import Unsatisfiable
from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.scene.lighting import AMBIENT, lighting_of
from probe.types import Array, Frame
from probe.world.scenes import make_scene


@dataclass(frozen=True, eq=False)
class Picture:
    """One scene.

    Attributes:
        seed: Of the scene.
        frame: Colours and depth alone.
        labels: Instance of each pixel, 0 for the table.
        seen: Instances of which at least 30 % and 400 px show.
    """

    seed: int
    frame: Frame
    labels: Array
    seen: tuple[int, ...]


def pictures(seeds: Sequence[int], lighting: str = AMBIENT.name) -> Iterator[Picture]:
    """One picture a seed, in a light by name; seeds that don't settle are named and left out."""
    things, tables = library("scans"), table_ids(assets_folder())
    with Renderer(cache_folder() / "light") as renderer:
        for seed in seeds:
            try:
                scene = make_scene(seed, things, tables)
            except Unsatisfiable as failure:
                print(failure, flush=True)
                continue
            load_scene(renderer, scene, things, load_table(scene.table, assets_folder()))
            light = light_of(lighting_of(lighting, scene.table), assets_folder())
            frame = photograph(renderer, scene, light=light)
            shown = measure(renderer, scene)
            seen = tuple(
                instance
                for instance, share in sorted(shown.items())
                if share.fraction >= SEEN_SHARE and share.visible_px >= SEEN_PX
            )
            assert frame.labels is not None
            yield Picture(seed, replace(frame, labels=None, shares=None), frame.labels, seen)


def noisy(frame: Frame, sigma: float, seed: int) -> Frame:
    """The frame with normal noise on its depth, metres."""
    if sigma == 0:
        return frame
    noise = np.random.default_rng(seed).normal(0.0, sigma, frame.depth.shape)
    return replace(frame, depth=(frame.depth + noise).astype(np.float32))
