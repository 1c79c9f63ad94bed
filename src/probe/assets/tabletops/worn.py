"""Table tops as the second version of looks has them: calmer figures, and traces of use."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.assets.tabletops.noise import fractal, ramp
from probe.assets.tabletops.sheet import TableTile, Top
from probe.assets.tabletops.stone import Granite, Marble, Terrazzo
from probe.assets.tabletops.wood import Planks
from probe.types import Array

_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_FADED = 0.10
"""How far colours are drawn towards their own grey."""


def paint_worn(top: Top, rng: np.random.Generator) -> TableTile:
    """One repeat of a table top that is in use."""
    return _used(_calmer(top).paint(rng), rng)


def _calmer(top: Top) -> Top:
    """The top with its figure at the scale and strength of the real thing.

    Boards are glued without a groove and their year rings are some 4 mm apart and nearly straight;
    veins of marble are soft; chips in terrazzo and grains in granite are a few millimetres wide.
    """
    if isinstance(top, Planks):
        changes = {"rings": 2.2 * top.rings, "sway": 3.2 * top.sway}
        changes |= {"contrast": 0.5 * top.contrast, "pores": 0.55 * top.pores}
        return top.model_copy(
            update=changes | {"variety": 0.6 * top.variety, "groove": 0.4 * top.groove}
        )
    if isinstance(top, Marble):
        return top.model_copy(update={"veined": 0.45 * top.veined, "softness": 3.0})
    if isinstance(top, Terrazzo):
        return top.model_copy(update={"tile_size": 0.6 * top.tile_size})
    if isinstance(top, Granite):
        return top.model_copy(update={"tile_size": 0.7 * top.tile_size})
    return top


def _used(tile: TableTile, rng: np.random.Generator) -> TableTile:
    """Faded, with broad differences in tone, a few stains, fine scratches and smudges."""
    broad = fractal(rng, slope=1.7, scale=1.5)
    smudge = fractal(rng, slope=1.4, scale=5)
    scratch = _scratches(rng)
    stain = ramp(fractal(rng, slope=1.9, scale=4), 1.7, 2.3)
    colour = tile.colour + _FADED * ((tile.colour @ _LUMINANCE)[..., None] - tile.colour)
    tone = 1 + 0.022 * broad + 0.008 * smudge + 0.02 * scratch - 0.02 * stain
    rough = tile.roughness * (1 + 0.16 * np.tanh(smudge) + 0.3 * scratch - 0.25 * stain)
    return replace(
        tile,
        colour=colour * tone[..., None],
        roughness_map=np.clip(rough, 0.06, 1),
    )


def _scratches(rng: np.random.Generator) -> Array:
    """Thin lines in two directions, here and there; 0 to 1."""
    lines = [fractal(rng, slope=0.0, stretch=way, finest=300) for way in ((40, 1.0), (1.0, 40))]
    where = ramp(fractal(rng, slope=1.5, scale=3), 0.4, 1.6)
    return where * np.maximum(ramp(lines[0], 2.0, 2.8), ramp(lines[1], 2.2, 3.0))
