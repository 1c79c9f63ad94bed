"""Table tops as the second version of looks has them: calmer figures, and traces of use."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.assets.tabletops.boards import glued
from probe.assets.tabletops.cloth import Felt, Gingham, Leather, Linen, Striped
from probe.assets.tabletops.folded import even, spread
from probe.assets.tabletops.laid import SheetMetal, Tiles
from probe.assets.tabletops.noise import fractal, ramp
from probe.assets.tabletops.sheet import TableTile, Top
from probe.assets.tabletops.stone import Cork, Granite, Marble, Terrazzo
from probe.assets.tabletops.veined import veined
from probe.assets.tabletops.wood import Planks
from probe.types import Array

_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_FADED = 0.10
"""How far colours are drawn towards their own grey."""
_WIDE = 0.5
"""Metres along an edge of a repeat that may have light and dark places."""


def paint_worn(top: Top, rng: np.random.Generator) -> TableTile:
    """One repeat of a table top that is in use; of cloth, a larger sheet."""
    if isinstance(top, Linen | Gingham | Striped):
        return _faded(spread(top.paint(rng), rng))
    return _used(_faded(_calmer(top, rng)), rng)


def _calmer(top: Top, rng: np.random.Generator) -> TableTile:
    """The top with its figure at the scale and strength of the real thing.

    Chips in terrazzo and grains in granite are a few millimetres wide; nothing that is made in
    one colour has clouds.
    """
    if isinstance(top, Planks):
        return glued(top, rng)
    if isinstance(top, Marble):
        return veined(top, rng)
    if isinstance(top, Terrazzo):
        return _even(top.model_copy(update={"tile_size": 0.6 * top.tile_size}).paint(rng))
    if isinstance(top, Granite):
        return _even(top.model_copy(update={"tile_size": 0.7 * top.tile_size}).paint(rng))
    if isinstance(top, Tiles):
        return top.model_copy(update={"speckle": 0.3 * top.speckle}).paint(rng)
    if isinstance(top, SheetMetal):
        return top.model_copy(update={"stain": 0.4 * top.stain}).paint(rng)
    if isinstance(top, Felt | Leather | Cork):
        return _even(top.paint(rng))
    return top.paint(rng)


def _even(tile: TableTile) -> TableTile:
    return replace(tile, colour=even(tile.colour))


def _faded(tile: TableTile) -> TableTile:
    grey = (tile.colour @ _LUMINANCE)[..., None]
    return replace(tile, colour=tile.colour + _FADED * (grey - tile.colour))


def _used(tile: TableTile, rng: np.random.Generator) -> TableTile:
    """With broad differences in tone, a few stains, fine scratches and smudges."""
    # On a small repeat, wide spots would come again and again.
    broad = fractal(rng, slope=1.7, scale=1.5) * (tile.tile_size >= _WIDE)
    smudge = fractal(rng, slope=1.4, scale=5)
    scratch = _scratches(rng)
    stain = ramp(fractal(rng, slope=1.9, scale=4), 1.7, 2.3)
    tone = 1 + 0.007 * broad + 0.004 * smudge + 0.02 * scratch - 0.012 * stain
    rough = tile.roughness * (1 + 0.16 * np.tanh(smudge) + 0.3 * scratch - 0.25 * stain)
    return replace(
        tile,
        colour=tile.colour * tone[..., None],
        roughness_map=np.clip(rough, 0.06, 1),
    )


def _scratches(rng: np.random.Generator) -> Array:
    """Thin lines in two directions, here and there; 0 to 1."""
    lines = [fractal(rng, slope=0.0, stretch=way, finest=300) for way in ((40, 1.0), (1.0, 40))]
    where = ramp(fractal(rng, slope=1.5, scale=3), 0.4, 1.6)
    return where * np.maximum(ramp(lines[0], 2.0, 2.8), ramp(lines[1], 2.2, 3.0))
