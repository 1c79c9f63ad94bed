"""Marble as the second version of looks has it: veins that run one way, fine ones between them."""

from __future__ import annotations

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, fractal, ramp
from probe.assets.tabletops.sheet import TableTile, rgb
from probe.assets.tabletops.stone import Marble
from probe.types import Array

_WAYS = ((1, 2), (1, 1), (2, 1), (1, -2), (2, -1))
"""Which way veins run: whole waves along u and v."""


def veined(marble: Marble, rng: np.random.Generator) -> TableTile:
    """One repeat of a marble top."""
    way = _WAYS[int(rng.integers(len(_WAYS)))]
    great = _veins(rng, way, bend=0.9, width=0.05)
    lesser = _veins(rng, (2 * way[0], 2 * way[1] + 1), bend=1.3, width=0.035)
    fine = _veins(rng, (3 * way[0], 3 * way[1] - 1), bend=1.8, width=0.02)
    halo = _veins(rng, way, bend=1.1, width=0.4)
    clouds = fractal(rng, slope=2.1, scale=2, stretch=(1.0, 1.4))
    base = blend(rgb(marble.ground), rgb(marble.clouds), ramp(clouds + 1.5 * halo, -0.8, 3.2))
    veins = np.maximum(np.maximum(0.55 * great, 0.3 * lesser), 0.22 * fine)
    colour = blend(base, rgb(marble.vein), 0.8 * marble.veined * veins)
    grain = fractal(rng, slope=0.3, scale=60) + 1.2 * fractal(rng, slope=1.0, scale=12)
    return TableTile(
        colour + 1.0 * grain[..., None], np.zeros((SIZE, SIZE)), marble.tile_size, marble.roughness
    )


def _veins(rng: np.random.Generator, way: tuple[int, int], bend: float, width: float) -> Array:
    """Long lines, 0 to 1, wider and fainter here and there, some of them lost."""
    v, u = (np.indices((SIZE, SIZE)) + 0.5) / SIZE
    warp = fractal(rng, slope=2.7, scale=2) + 0.03 * fractal(rng, slope=1.9, scale=10)
    line: Array = np.sin(2 * np.pi * (way[0] * u + way[1] * v) + bend * 1.6 * warp)
    breadth = width * np.exp(0.7 * fractal(rng, slope=1.6, scale=3))
    where = ramp(fractal(rng, slope=1.7, scale=2), -0.4, 1.2)
    return where * np.exp(-((line / breadth) ** 2) / 2) * np.minimum(1, width / breadth * 1.2)
