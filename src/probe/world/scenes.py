"""From a seed to a settled Scene."""

from __future__ import annotations

from collections.abc import Sequence

from probe.assets.library import Library
from probe.errors import Unsatisfiable
from probe.scene.sampling import DEFAULT_COUNT, TIGHT, Pile, draw_objects, draw_pile
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.world.model import Item
from probe.world.settle import settle

ATTEMPTS = 5
"""Draws of a whole scene before giving up."""


def make_scene(
    seed: int,
    library: Library,
    tables: Sequence[str],
    count: int = DEFAULT_COUNT,
    pile: Pile = TIGHT,
) -> Scene:
    """Draw objects and a table, drop the objects and let them settle.

    Raises:
        Unsatisfiable: No draw came to rest; the message holds the last reason.
    """
    table = tables[int(generator(seed, "table").integers(len(tables)))]
    reason = ""
    for attempt in range(ATTEMPTS):
        rng = generator(seed, "pile", attempt)
        specs = draw_objects(library.specs, count, rng)
        items = [Item(n, spec, library.body(spec.id)) for n, spec in enumerate(specs, start=1)]
        falls = draw_pile(specs, pile, rng)
        drops = {items[index].instance: drop for index, drop in falls}
        try:
            return Scene(seed, table, settle([items[index] for index, _ in falls], drops, rng))
        except Unsatisfiable as failure:
            reason = str(failure)
    raise Unsatisfiable(
        f"Seed {seed}: no settled scene of {count} objects in {ATTEMPTS} draws. {reason} "
        "Try another seed or fewer objects."
    )
