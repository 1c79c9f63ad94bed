"""From a seed to a settled Scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.errors import Unsatisfiable
from probe.scene.sampling import DEFAULT_COUNT, TIGHT, PileSettings, draw_objects, draw_pile
from probe.scene.scene import PlacedObject, Scene
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE, Setup
from probe.world.model import Item
from probe.world.rest import scene_unrest
from probe.world.settle import settle

ATTEMPTS = 5
"""Draws of a whole scene before giving up."""


@dataclass(frozen=True)
class SettledScene:
    """A settled scene, and what it took.

    Attributes:
        restless: How many draws before it had settled in their pile, yet moved once their table was
            rebuilt.
    """

    scene: Scene
    restless: int


def make_scene(
    seed: int,
    library: Library,
    tables: Sequence[str],
    count: int = DEFAULT_COUNT,
    pile: PileSettings = TIGHT,
    setup: Setup = UR5_TABLE,
) -> Scene:
    """The scene of draw_scene() alone."""
    return draw_scene(seed, library, tables, count, pile, setup).scene


def draw_scene(
    seed: int,
    library: Library,
    tables: Sequence[str],
    count: int = DEFAULT_COUNT,
    pile: PileSettings = TIGHT,
    setup: Setup = UR5_TABLE,
) -> SettledScene:
    """Draw objects and a table, drop the objects and let them settle.

    Nothing moves once the table is rebuilt (scene_unrest()); where something would, all is
    dropped again with the seed's next draw.

    Raises:
        Unsatisfiable: No draw came to rest; the message holds the last reason. Or the pile is wider
            than the set-up's work area.
    """
    pile.check_reach(setup)
    table = tables[int(generator(seed, "table").integers(len(tables)))]
    reason, restless = "", 0
    for attempt in range(ATTEMPTS):
        try:
            objects = _settled(library, count, pile, generator(seed, "pile", attempt), setup)
        except Unsatisfiable as failure:
            reason = str(failure)
            continue
        scene = Scene(seed, table, objects, setup)
        moving = scene_unrest(scene, library)
        if moving is None:
            return SettledScene(scene, restless)
        reason, restless = f"On a rebuilt table, {moving}.", restless + 1
    raise Unsatisfiable(
        f"Seed {seed}: no settled scene of {count} objects in {ATTEMPTS} draws. {reason} "
        "Try another seed or fewer objects."
    )


def _settled(
    library: Library, count: int, pile: PileSettings, rng: np.random.Generator, setup: Setup
) -> tuple[PlacedObject, ...]:
    specs = draw_objects(library.specs, count, rng, library.leads)
    items = [Item(n, spec, library.form(spec.id)) for n, spec in enumerate(specs, start=1)]
    falls = draw_pile(specs, pile, rng)
    drops = {items[index].instance: drop for index, drop in falls}
    return settle([items[index] for index, _ in falls], drops, rng, setup)
