"""Table tops of wood: staves with year rings, fibres and pores."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, fractal, moved, ramp
from probe.assets.tabletops.sheet import Colour, TableTile, Top, rgb
from probe.types import Array


class Planks(Top):
    """Staves along u, each cut from another part of the tree.

    Attributes:
        light, dark: Early and late wood.
        staves: How many lie side by side on a repeat.
        rings: Year rings across a repeat.
        contrast: Of the rings, 0 to 1.
        pores: Share of dark pores, 0 to 1.
        variety: Difference in brightness between staves, in grey levels.
        groove: Pixels of dark joint between staves.
        sway: How straight the rings run; at 14 they sway by about 3 cm.
    """

    kind: Literal["planks"]
    light: Colour
    dark: Colour
    staves: int
    tile_size: float = 0.8
    rings: float = 90.0
    contrast: float = 0.6
    pores: float = 0.5
    variety: float = 10.0
    groove: float = 1.2
    sway: float = 14.0
    roughness: float = 0.55

    def paint(self, rng: np.random.Generator) -> TableTile:
        return _planks(self, rng)


def _planks(timber: Planks, rng: np.random.Generator) -> TableTile:
    width = SIZE / timber.staves
    stave = np.minimum((np.arange(SIZE) / width).astype(int), timber.staves - 1)
    shift_v = rng.integers(0, SIZE, timber.staves)[stave][:, None] * np.ones((1, SIZE))
    shift_u = rng.integers(0, SIZE, timber.staves)[stave][:, None] * np.ones((1, SIZE))
    tone = rng.normal(0, timber.variety, timber.staves)[stave][:, None]

    rings = moved(_rings(timber, rng), shift_v, shift_u)
    fibres = moved(fractal(rng, slope=0.6, scale=30, stretch=(40, 1)), shift_v, shift_u)
    pores = moved(_pores(rng), shift_v, shift_u) * timber.pores
    clouds = fractal(rng, slope=1.6, scale=2, stretch=(4, 1))

    light, dark = rgb(timber.light), rgb(timber.dark)
    colour = blend(light, dark, rings * timber.contrast)
    colour = colour + (tone + 3.5 * fibres + 3.0 * clouds)[..., None] * np.array([1.0, 0.95, 0.85])
    colour = blend(colour, dark * 0.6, 0.7 * pores)
    joint = _joints(width, timber.groove)
    colour = blend(colour, dark * 0.4, 0.85 * joint)
    height = 2e-5 * fibres - 6e-5 * pores - 3e-4 * joint
    return TableTile(colour, height, timber.tile_size, timber.roughness)


def _rings(timber: Planks, rng: np.random.Generator) -> Array:
    """Late wood, 0 to 1: a saw-tooth over a surface that is warped along the grain."""
    warp = 1.6 * fractal(rng, slope=2.2, scale=1.5, stretch=(6, 1), finest=60)
    warp = warp + 0.06 * fractal(rng, slope=1.0, scale=20, stretch=(20, 1))
    v = np.arange(SIZE)[:, None] / SIZE
    phase = timber.rings * v + timber.rings / timber.sway * warp
    tooth = phase % 1.0
    late = ramp(tooth, 0.25, 0.9) * ramp(tooth, 1.0, 0.92)
    strength = 0.65 + 0.35 * np.tanh(fractal(rng, slope=1.5, scale=3, stretch=(5, 1)))
    return late * strength


def _pores(rng: np.random.Generator) -> Array:
    """Short dark lines along the grain, 0 to 1."""
    lines = fractal(rng, slope=0.0, stretch=(22, 1.2), finest=330)
    where = fractal(rng, slope=1.2, scale=6, stretch=(8, 1))
    return ramp(lines + 0.5 * where, 1.6, 2.6)


def _joints(width: float, groove: float) -> Array:
    """Dark lines between staves, 0 to 1, shape (SIZE, SIZE)."""
    place = (np.arange(SIZE) + 0.5) % width
    distance = np.minimum(place, width - place)
    return np.repeat(ramp(distance, groove + 1.0, groove * 0.4)[:, None], SIZE, axis=1)
