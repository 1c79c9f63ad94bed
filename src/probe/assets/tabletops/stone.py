"""Table tops of stone, and of stone chips or cork held by a binder."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, cells, fractal, ramp
from probe.assets.tabletops.sheet import Colour, TableTile, Top, palette, rgb
from probe.types import Array


class Granite(Top):
    """Fine grains.

    Attributes:
        grains: The commonest mineral first.
    """

    kind: Literal["granite"]
    grains: tuple[Colour, Colour, Colour, Colour]
    tile_size: float = 0.5
    roughness: float = 0.35

    def paint(self, rng: np.random.Generator) -> TableTile:
        grain, _, _ = cells(rng, 160, warp=0.25)
        kind = rng.choice(4, 160 * 160, p=[0.5, 0.24, 0.14, 0.12])
        shade = rng.normal(0, 9, 160 * 160)
        colour = palette(self.grains)[kind][grain] + shade[grain][..., None]
        clouds = fractal(rng, slope=1.4, scale=3)
        colour = colour + (5 * clouds + 4 * fractal(rng, slope=0.4, scale=80))[..., None]
        return TableTile(colour, 1e-5 * clouds, self.tile_size, self.roughness)


class Marble(Top):
    """Clouds and thin veins.

    Attributes:
        ground, clouds, vein: Their colours.
        veined: Strength of the veins.
        softness: Factor on their width.
    """

    kind: Literal["marble"]
    ground: Colour
    clouds: Colour
    vein: Colour
    veined: float = 1.0
    softness: float = 1.0
    tile_size: float = 1.0
    roughness: float = 0.25

    def paint(self, rng: np.random.Generator) -> TableTile:
        clouds = fractal(rng, slope=2.3, scale=2, stretch=(1.0, 1.5))
        veins = np.zeros((SIZE, SIZE))
        for width, strength in ((0.07, 0.75), (0.03, 0.5), (0.015, 0.35)):
            line = fractal(rng, slope=2.1, scale=2, stretch=(1.0, 1.8))
            line = line + 0.04 * fractal(rng, slope=1.3)
            where = ramp(fractal(rng, slope=1.8, scale=2), -0.2, 1.0)
            veins = np.maximum(
                veins, strength * where * np.exp(-np.abs(line) / (width * self.softness))
            )
        base = blend(rgb(self.ground), rgb(self.clouds), ramp(clouds, -1.5, 3.0))
        colour = blend(base, rgb(self.vein), self.veined * veins)
        colour = colour + 1.2 * fractal(rng, slope=0.3, scale=60)[..., None]
        return TableTile(colour, np.zeros((SIZE, SIZE)), self.tile_size, self.roughness)


class Slate(Top):
    """In thin cleft layers."""

    kind: Literal["slate"]
    cool: Colour
    warm: Colour
    tile_size: float = 0.6
    roughness: float = 0.75

    def paint(self, rng: np.random.Generator) -> TableTile:
        relief = fractal(rng, slope=1.5, scale=2, stretch=(1.6, 1.0))
        layers = np.floor(relief * 3.5 + 0.25 * fractal(rng, slope=1.2, scale=12))
        fine = fractal(rng, slope=0.7, scale=40)
        tint = fractal(rng, slope=1.8, scale=2)
        colour = blend(rgb(self.cool), rgb(self.warm), ramp(tint, -1, 2))
        colour = colour + (4 * (layers % 3 - 1) + 5 * fine + 5 * relief)[..., None]
        return TableTile(colour, 1.2e-4 * layers + 3e-5 * fine, self.tile_size, self.roughness)


class Terrazzo(Top):
    """Chips of several stones in cement, ground flat."""

    kind: Literal["terrazzo"]
    cement: Colour
    chips: tuple[Colour, ...]
    tile_size: float = 0.6
    roughness: float = 0.35

    def paint(self, rng: np.random.Generator) -> TableTile:
        colour = np.full((SIZE, SIZE, 3), rgb(self.cement).astype(float))
        colour = colour + (3 * fractal(rng, slope=0.8, scale=30))[..., None]
        stones = palette(self.chips)
        for across in (52, 27, 13):
            inside, chip = _chips(rng, across)
            count = across * across
            tone = stones[rng.integers(0, len(stones), count)] + rng.normal(0, 7, (count, 1))
            texture = 4 * fractal(rng, slope=0.7, scale=40)[..., None]
            colour = blend(colour, tone[chip] + texture, inside)
        return TableTile(colour, np.zeros((SIZE, SIZE)), self.tile_size, self.roughness)


class Cork(Top):
    """Pressed granules, a few dark."""

    kind: Literal["cork"]
    granule: Colour
    gap: Colour
    tile_size: float = 0.45
    roughness: float = 0.9

    def paint(self, rng: np.random.Generator) -> TableTile:
        granule, _, edge = cells(rng, 72, warp=0.3)
        tone = rng.normal(0, 15, 72 * 72) - 55 * (rng.random(72 * 72) < 0.06)
        fine = fractal(rng, slope=0.5, scale=90)
        colour = rgb(self.granule) + (tone[granule] + 7 * fine)[..., None] * [1, 0.9, 0.75]
        gap = ramp(edge, 0.16, 0.0)
        colour = blend(colour, rgb(self.gap), 0.55 * gap)
        return TableTile(colour, 2e-4 * (1 - gap) + 4e-5 * fine, self.tile_size, self.roughness)


class CastStone(Top):
    """Concrete, plaster or resin: clouds, fine grain, pits, all of one colour.

    Attributes:
        stain: Grey levels of the clouds.
        pits: Share of the surface with air holes, 0 to 1.
    """

    kind: Literal["cast"]
    colour: Colour
    stain: float = 7.0
    pits: float = 0.3
    tile_size: float = 0.9
    roughness: float = 0.75

    def paint(self, rng: np.random.Generator) -> TableTile:
        clouds = fractal(rng, slope=1.6, scale=2)
        fine = fractal(rng, slope=0.6, scale=50)
        hole, distance, _ = cells(rng, 60)
        size = np.where(rng.random(3600) < 0.25 * self.pits, rng.uniform(0.02, 0.14, 3600), -1.0)
        pit = ramp(distance - size[hole], 0.02, -0.02)
        colour = rgb(self.colour) + (self.stain * clouds + 3.5 * fine)[..., None]
        colour = colour * (1 - 0.45 * pit[..., None])
        return TableTile(colour, 2e-5 * fine - 3e-4 * pit, self.tile_size, self.roughness)


def _chips(rng: np.random.Generator, across: int) -> tuple[Array, Array]:
    """Angular chips: how much each pixel lies inside one (0 to 1), and which."""
    chip, distance, edge = cells(rng, across, warp=0.12)
    reach = rng.uniform(0.05, 0.42, across * across)
    rim = np.minimum(reach[chip] - distance, edge / 2 - 0.04) * SIZE / across
    return ramp(rim, -0.7, 0.7), chip
