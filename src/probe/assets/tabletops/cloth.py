"""Table tops covered with woven cloth, felt, leather or laminate."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, cells, fractal, ramp
from probe.assets.tabletops.sheet import Colour, TableTile, Top, palette, rgb
from probe.types import Array

THREADS = 128
"""Threads along an edge of a repeat; even, so that a plain weave closes."""


class Linen(Top):
    """Plain weave of one colour, with slubs."""

    kind: Literal["linen"]
    colour: Colour
    tile_size: float = 0.16
    roughness: float = 0.95

    def paint(self, rng: np.random.Generator) -> TableTile:
        weave, height = _weave(rng)
        colour = rgb(self.colour) + (26 * weave)[..., None] * [1, 1, 0.95]
        colour = colour + (2.5 * fractal(rng, slope=1.5, scale=2))[..., None]
        return TableTile(colour, height, self.tile_size, self.roughness)


class Gingham(Top):
    """Checks of two colours, woven: half coloured where a thread crosses a white one."""

    kind: Literal["gingham"]
    colour: Colour
    ground: Colour = "#f0ece6"
    tile_size: float = 0.12
    roughness: float = 0.95

    def paint(self, rng: np.random.Generator) -> TableTile:
        weave, height = _weave(rng)
        stripe = (np.arange(SIZE) // (SIZE // 4)) % 2
        share = (stripe[:, None] + stripe[None, :]) / 2 * np.ones((SIZE, SIZE))
        colour = blend(rgb(self.ground), rgb(self.colour), share)
        return TableTile(colour + (20 * weave)[..., None], height, self.tile_size, self.roughness)


class Striped(Top):
    """Woven bands of several colours, along u alone or both ways as in a tartan.

    Attributes:
        bands: Colour of each band and how many threads of 128 it has; all together 128.
        crossed: The same bands down the columns too.
    """

    kind: Literal["striped"]
    bands: tuple[tuple[Colour, int], ...]
    crossed: bool = False
    tile_size: float = 0.2
    roughness: float = 0.95

    def paint(self, rng: np.random.Generator) -> TableTile:
        weave, height = _weave(rng)
        counts = [count * SIZE // THREADS for _, count in self.bands]
        line = np.repeat(palette([colour for colour, _ in self.bands]), counts, axis=0)
        rows = np.repeat(line[:, None], SIZE, axis=1).astype(float)
        colour = (rows + rows.transpose(1, 0, 2)) / 2 if self.crossed else rows
        return TableTile(colour + (18 * weave)[..., None], height, self.tile_size, self.roughness)


class Felt(Top):
    """Short fibres in all directions."""

    kind: Literal["felt"]
    colour: Colour
    tint: tuple[float, float, float] = (1.0, 1.0, 1.0)
    tile_size: float = 0.35
    roughness: float = 1.0

    def paint(self, rng: np.random.Generator) -> TableTile:
        fibres = np.zeros((SIZE, SIZE))
        for stretch in ((7, 1), (1, 7), (4, 2), (2, 4)):
            fibres = fibres + fractal(rng, slope=0.5, scale=60, stretch=stretch)
        fibres = fibres + 1.5 * fractal(rng, slope=0.5, scale=60)
        clouds = fractal(rng, slope=1.5, scale=3)
        colour = rgb(self.colour) + (5 * fibres + 2.5 * clouds)[..., None] * self.tint
        return TableTile(colour, 3e-5 * fibres, self.tile_size, self.roughness)


class Laminate(Top):
    """One colour, with a faint orange peel."""

    kind: Literal["laminate"]
    colour: Colour
    tile_size: float = 0.8
    roughness: float = 0.4

    def paint(self, rng: np.random.Generator) -> TableTile:
        peel = fractal(rng, slope=1.0, scale=90, finest=200)
        clouds = fractal(rng, slope=1.8, scale=2)
        colour = rgb(self.colour) + (0.9 * peel + 1.0 * clouds)[..., None]
        return TableTile(colour, 6e-6 * peel, self.tile_size, self.roughness)


class Leather(Top):
    """Grain of small rounded cells, darker in the folds between them."""

    kind: Literal["leather"]
    colour: Colour
    grain: int = 90
    tile_size: float = 0.3
    roughness: float = 0.5

    def paint(self, rng: np.random.Generator) -> TableTile:
        cell, _, edge = cells(rng, self.grain, warp=0.35)
        fold = ramp(edge, 0.3, 0.0)
        tone = rng.normal(0, 0.03, self.grain**2)[cell]
        clouds = fractal(rng, slope=1.7, scale=2)
        shade = 1 + tone + 0.05 * clouds - 0.3 * fold + 0.015 * fractal(rng, slope=0.4, scale=90)
        return TableTile(
            rgb(self.colour) * shade[..., None], -2e-4 * fold, self.tile_size, self.roughness
        )


def _weave(rng: np.random.Generator) -> tuple[Array, Array]:
    """Brightness (about -1 to 1) and height in metres of a plain weave."""
    uneven = 0.9 * fractal(rng, slope=1.6, scale=4, stretch=(6, 1), finest=90)
    rows, columns = np.indices((SIZE, SIZE))
    along_u: Array = rows * THREADS / SIZE + 0.12 * uneven
    along_v: Array = columns * THREADS / SIZE + 0.12 * np.roll(uneven, SIZE // 3).T
    over = np.where((np.floor(along_u) + np.floor(along_v)) % 2 == 0, 1.0, 0.0)
    round_u: Array = np.sin(np.pi * (along_u % 1.0))
    round_v: Array = np.sin(np.pi * (along_v % 1.0))
    top: Array = np.where(
        over > 0, round_u * (0.6 + 0.4 * round_v), round_v * (0.6 + 0.4 * round_u)
    )
    slub_u = _threads(rng, along_u)
    slub_v = _threads(rng, along_v)
    tone = np.where(over > 0, slub_u, slub_v)
    fuzz = 0.12 * fractal(rng, slope=0.3, scale=80)
    return top - 0.75 + 0.22 * tone + fuzz, 1.5e-4 * top


def _threads(rng: np.random.Generator, place: Array) -> Array:
    """Brightness of the thread at each place, its own for every thread."""
    return rng.normal(0, 1, THREADS)[np.floor(place).astype(int) % THREADS]
