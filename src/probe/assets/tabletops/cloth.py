"""Table tops covered with cloth, felt or laminate."""

from __future__ import annotations

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, fractal
from probe.assets.tabletops.sheet import Sheet
from probe.types import Array

THREADS = 128
"""Threads along an edge of a repeat; even, so that a plain weave closes."""


def linen(rng: np.random.Generator) -> Sheet:
    """Undyed plain weave with slubs."""
    weave, height = _weave(rng)
    colour = np.array([212.0, 203.0, 184.0]) + (26 * weave)[..., None] * [1, 1, 0.95]
    colour = colour + (2.5 * fractal(rng, slope=1.5, scale=2))[..., None]
    return Sheet(colour, height, 0.16, 0.95)


def gingham(rng: np.random.Generator) -> Sheet:
    """White and red checks, woven: half red where a red thread crosses a white one."""
    weave, height = _weave(rng)
    stripe = (np.arange(SIZE) // (SIZE // 4)) % 2
    red = (stripe[:, None] + stripe[None, :]) / 2 * np.ones((SIZE, SIZE))
    colour = blend(np.array([240, 236, 230]), np.array([176, 38, 44]), red)
    return Sheet(colour + (20 * weave)[..., None], height, 0.12, 0.95)


def felt(rng: np.random.Generator) -> Sheet:
    """Green felt: short fibres in all directions."""
    fibres = np.zeros((SIZE, SIZE))
    for stretch in ((7, 1), (1, 7), (4, 2), (2, 4)):
        fibres = fibres + fractal(rng, slope=0.5, scale=60, stretch=stretch)
    fibres = fibres + 1.5 * fractal(rng, slope=0.5, scale=60)
    clouds = fractal(rng, slope=1.5, scale=3)
    colour = np.array([44.0, 96.0, 72.0]) + (5 * fibres + 2.5 * clouds)[..., None] * [0.8, 1, 0.9]
    return Sheet(colour, 3e-5 * fibres, 0.35, 1.0)


def laminate(rng: np.random.Generator) -> Sheet:
    """White laminate with a faint orange peel."""
    peel = fractal(rng, slope=1.0, scale=90, finest=200)
    clouds = fractal(rng, slope=1.8, scale=2)
    colour = np.array([236.0, 236.0, 233.0]) + (0.9 * peel + 1.0 * clouds)[..., None]
    return Sheet(colour, 6e-6 * peel, 0.8, 0.4)


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
