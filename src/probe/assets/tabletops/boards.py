"""Wooden table tops as the second version of looks has them: boards cut from round trunks.

A board's figure is what its plane meets of year rings, which are cylinders round a pith that
wanders: near the pith's side of a board they are wide arches, elsewhere narrow lines.
"""

from __future__ import annotations

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, fractal, moved, ramp
from probe.assets.tabletops.sheet import TableTile, rgb
from probe.assets.tabletops.wood import Planks
from probe.types import Array

_SLABS = 2.0
"""Grooves of so many pixels and more are there by intent, in tops that are painted or rough;
narrower ones are joints of glue."""


def glued(timber: Planks, rng: np.random.Generator) -> TableTile:
    """One repeat of a table top that is glued of boards."""
    board, edge, width = _boards(timber.staves, rng)
    shift_v, shift_u = rng.integers(0, SIZE, (2, timber.staves))[:, board]
    along = np.ones((1, SIZE))
    fibres = moved(
        fractal(rng, slope=0.6, scale=30, stretch=(40, 1)),
        shift_v[:, None] * along,
        shift_u[:, None] * along,
    )
    pores = moved(_pores(rng), shift_u[:, None] * along, shift_v[:, None] * along)
    rings = _figure(timber, board, width, rng)
    slabs = timber.groove >= _SLABS
    tone = rng.normal(0, 0.6 * timber.variety, timber.staves)[board][:, None]
    warmth = rng.normal(0, 0.003 if slabs else 0.012, timber.staves)[board][
        :, None, None
    ] * np.array([1.0, 0.1, -1.2])
    light, dark = rgb(timber.light), rgb(timber.dark)
    colour = blend(light, dark, rings * 0.62 * timber.contrast)
    colour = (colour + (tone + 3.0 * fibres)[..., None] * np.array([1.0, 0.95, 0.85])) * (
        1 + warmth
    )
    colour = blend(colour, dark * 0.6, 0.45 * timber.pores * pores)
    joint = _joints(edge, timber.groove if slabs else 0.3)
    colour = blend(colour, dark * 0.4, (0.7 if slabs else 0.3) * joint)
    height = 2e-5 * fibres - 4e-5 * timber.pores * pores - (3e-4 if slabs else 3e-5) * joint
    return TableTile(colour, height, timber.tile_size, timber.roughness)


def _boards(count: int, rng: np.random.Generator) -> tuple[Array, Array, Array]:
    """Each row's board, its distance to the board's edge in pixels, and how wide boards are."""
    shares = rng.uniform(0.8, 1.2, count)
    ends = np.concatenate([[0.0], np.cumsum(shares) / shares.sum() * SIZE])
    row = np.arange(SIZE) + 0.5
    board = np.minimum(np.searchsorted(ends, row) - 1, count - 1)
    return board, np.minimum(row - ends[board], ends[board + 1] - row), np.diff(ends)


def _figure(timber: Planks, board: Array, width: Array, rng: np.random.Generator) -> Array:
    """Late wood, 0 to 1: how far into its year ring each place is."""
    metre = SIZE / timber.tile_size
    ring = timber.tile_size / (2.2 * timber.rings)
    count = timber.staves
    middle = np.cumsum(width) - width / 2
    # Where the pith runs beside and below each board's middle; the farther, the straighter.
    beside = rng.choice((-1, 1), count) * rng.uniform(0.1, 1.1, count) * width / metre
    below = rng.uniform(0.01, 0.09, count)
    across = (np.arange(SIZE) + 0.5 - middle[board]) / metre - beside[board]
    depth = below[:, None] + _wander(rng, count, 0.12 * below[:, None] + 0.003)
    aside = across[:, None] - _wander(rng, count, np.full((count, 1), 0.004))[board]
    sway = 0.0012 * fractal(rng, slope=2.0, scale=2, stretch=(6, 1), finest=60)
    sway += 0.00012 * fractal(rng, slope=1.0, scale=20, stretch=(20, 1))
    radius = np.hypot(aside, depth[board]) + sway
    years = radius / ring
    years = years + 0.35 * np.sin(0.9 * years) + 0.2 * np.sin(2.3 * years + 1)
    tooth = years % 1.0
    late = ramp(tooth, 0.1, 0.9) * ramp(tooth, 1.0, 0.9)
    strength = 0.65 + 0.35 * np.tanh(fractal(rng, slope=1.5, scale=3, stretch=(5, 1)))
    return late * strength * rng.uniform(0.6, 1.15, count)[board][:, None]


def _wander(rng: np.random.Generator, count: int, most: Array) -> Array:
    """How far each board's pith strays along the board, metres, shape (count, SIZE)."""
    turn = 2 * np.pi * (np.arange(SIZE) + 0.5) / SIZE
    total = np.zeros((count, SIZE))
    for waves in (1, 2):
        phase, part = rng.uniform(0, 2 * np.pi, (count, 1)), rng.uniform(0.4, 1.0, (count, 1))
        total += part / waves**2 * np.sin(waves * turn + phase)
    return most * total


def _pores(rng: np.random.Generator) -> Array:
    """Short dark lines along the grain, 0 to 1."""
    lines = fractal(rng, slope=0.0, stretch=(16, 1.2), finest=420)
    where = fractal(rng, slope=1.2, scale=6, stretch=(8, 1))
    return ramp(lines + 0.5 * where, 1.7, 2.6)


def _joints(edge: Array, groove: float) -> Array:
    """Dark lines between boards, 0 to 1, shape (SIZE, SIZE)."""
    return np.repeat(ramp(edge, groove + 0.8, groove * 0.4)[:, None], SIZE, axis=1)
