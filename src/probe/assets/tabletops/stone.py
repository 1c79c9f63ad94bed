"""Table tops of stone, and of stone chips or cork held by a binder."""

from __future__ import annotations

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, cells, fractal, ramp
from probe.assets.tabletops.sheet import Sheet
from probe.types import Array


def granite(rng: np.random.Generator) -> Sheet:
    """Fine grains of grey feldspar, pale quartz and black mica."""
    grain, _, _ = cells(rng, 160, warp=0.25)
    kind = rng.choice(4, 160 * 160, p=[0.5, 0.24, 0.14, 0.12])
    palette = np.array([[146, 146, 145], [184, 182, 177], [106, 106, 108], [52, 52, 55]])
    shade = rng.normal(0, 9, 160 * 160)
    colour = palette[kind][grain] + shade[grain][..., None]
    clouds = fractal(rng, slope=1.4, scale=3)
    colour = colour + (5 * clouds + 4 * fractal(rng, slope=0.4, scale=80))[..., None]
    return Sheet(colour, 1e-5 * clouds, 0.5, 0.35)


def marble(rng: np.random.Generator) -> Sheet:
    """White, with grey clouds and thin veins."""
    clouds = fractal(rng, slope=2.3, scale=2, stretch=(1.0, 1.5))
    veins = np.zeros((SIZE, SIZE))
    for width, strength in ((0.07, 0.75), (0.03, 0.5), (0.015, 0.35)):
        line = fractal(rng, slope=2.1, scale=2, stretch=(1.0, 1.8)) + 0.04 * fractal(rng, slope=1.3)
        where = ramp(fractal(rng, slope=1.8, scale=2), -0.2, 1.0)
        veins = np.maximum(veins, strength * where * np.exp(-np.abs(line) / width))
    base = blend(np.array([238, 237, 234]), np.array([214, 215, 217]), ramp(clouds, -1.5, 3.0))
    colour = blend(base, np.array([120, 122, 128]), veins)
    colour = colour + 1.2 * fractal(rng, slope=0.3, scale=60)[..., None]
    return Sheet(colour, np.zeros((SIZE, SIZE)), 1.0, 0.25)


def slate(rng: np.random.Generator) -> Sheet:
    """Dark, in thin cleft layers."""
    relief = fractal(rng, slope=1.5, scale=2, stretch=(1.6, 1.0))
    layers = np.floor(relief * 3.5 + 0.25 * fractal(rng, slope=1.2, scale=12))
    fine = fractal(rng, slope=0.7, scale=40)
    tint = fractal(rng, slope=1.8, scale=2)
    colour = blend(np.array([72, 77, 84]), np.array([88, 86, 82]), ramp(tint, -1, 2))
    colour = colour + (4 * (layers % 3 - 1) + 5 * fine + 5 * relief)[..., None]
    return Sheet(colour, 1.2e-4 * layers + 3e-5 * fine, 0.6, 0.75)


def terrazzo(rng: np.random.Generator) -> Sheet:
    """Chips of several stones in pale cement, ground flat."""
    colour = np.full((SIZE, SIZE, 3), [221.0, 216.0, 206.0])
    colour = colour + (3 * fractal(rng, slope=0.8, scale=30))[..., None]
    palette = np.array(
        [
            [62, 62, 66],
            [160, 92, 70],
            [196, 160, 108],
            [122, 134, 128],
            [245, 243, 238],
            [150, 150, 150],
        ]
    )
    for across in (52, 27, 13):
        inside, chip = _chips(rng, across)
        count = across * across
        tone = palette[rng.integers(0, len(palette), count)] + rng.normal(0, 7, (count, 1))
        texture = 4 * fractal(rng, slope=0.7, scale=40)[..., None]
        colour = blend(colour, tone[chip] + texture, inside)
    return Sheet(colour, np.zeros((SIZE, SIZE)), 0.6, 0.35)


def cork(rng: np.random.Generator) -> Sheet:
    """Pressed brown granules, a few dark."""
    granule, _, edge = cells(rng, 72, warp=0.3)
    tone = rng.normal(0, 15, 72 * 72) - 55 * (rng.random(72 * 72) < 0.06)
    fine = fractal(rng, slope=0.5, scale=90)
    colour = np.array([186.0, 140.0, 94.0]) + (tone[granule] + 7 * fine)[..., None] * [1, 0.9, 0.75]
    gap = ramp(edge, 0.16, 0.0)
    colour = blend(colour, np.array([112, 76, 46]), 0.55 * gap)
    return Sheet(colour, 2e-4 * (1 - gap) + 4e-5 * fine, 0.45, 0.9)


def _chips(rng: np.random.Generator, across: int) -> tuple[Array, Array]:
    """Angular chips: how much each pixel lies inside one (0 to 1), and which."""
    chip, distance, edge = cells(rng, across, warp=0.12)
    reach = rng.uniform(0.05, 0.42, across * across)
    rim = np.minimum(reach[chip] - distance, edge / 2 - 0.04) * SIZE / across
    return ramp(rim, -0.7, 0.7), chip
