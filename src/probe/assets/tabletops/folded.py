"""Cloth on a table as the second version of looks has it: a large sheet with folds and creases."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.assets.tabletops.noise import fractal, ramp
from probe.assets.tabletops.sheet import TableTile
from probe.types import Array

SHEET_PX = 2048
"""Pixels along an edge of a sheet: twice those of what it is made of."""

_LEAST = 0.55
"""Metres along an edge of a sheet at least."""

_WAVES = 7
"""Waves along an edge that are still too broad: again and again, they show that it repeats."""


def spread(cloth: TableTile, rng: np.random.Generator) -> TableTile:
    """A sheet of several repeats of a cloth, evened out, with creases in it."""
    count = int(np.ceil(_LEAST / cloth.tile_size))
    colour = _repeated(even(cloth.colour, banded=True), count)
    height = _repeated(cloth.height[..., None], count)[..., 0]
    crease = _twice(_creases(rng))
    sag = _twice(fractal(rng, slope=2.2, scale=2, finest=24))
    return replace(
        cloth,
        colour=colour * (1 + 0.03 * crease)[..., None],
        height=height + 6e-4 * sag + 7e-4 * crease,
        tile_size=count * cloth.tile_size,
    )


def even(colour: Array, *, banded: bool = False) -> Array:
    """A repeat without what is lighter or darker over a wide part of it.

    Args:
        colour: Shape (n, n, 3).
        banded: Whether bands along its edges are its pattern, and stay.
    """
    size = len(colour)
    waves = np.fft.fftfreq(size, 1 / size)
    away = np.hypot(waves[None, :], waves[:, None])
    broad = np.exp(-((away / _WAVES) ** 2)) * (away > 0)
    if banded:
        broad = broad * (waves[None, :] != 0) * (waves[:, None] != 0)
    light = colour.mean(axis=2)
    wide = np.fft.ifft2(np.fft.fft2(light) * broad).real
    return colour * (1 - wide / np.maximum(light, 1))[..., None]


def _creases(rng: np.random.Generator) -> Array:
    """Where it was folded, crossed at right angles, and soft wrinkles; -1 to 1."""
    wrinkle = fractal(rng, slope=1.9, scale=3, stretch=(1.6, 1.0), finest=60)
    where = ramp(fractal(rng, slope=1.8, scale=2), -0.2, 1.4)
    ridge = np.exp(-np.abs(wrinkle) / 0.06) * where
    size = len(ridge)
    place = (np.arange(size) / size + rng.random() - 0.5) % 1 - 0.5
    across = (np.arange(size) / size + rng.random() - 0.5) % 1 - 0.5
    fold = np.exp(-np.abs(place) / 0.006)[:, None] + 0.7 * np.exp(-np.abs(across) / 0.006)
    return 0.35 * ridge - 0.6 * np.minimum(fold, 1)


def _repeated(repeat: Array, count: int) -> Array:
    """A repeat so many times across and down, shape (SHEET_PX, SHEET_PX, channels)."""
    size = len(repeat)
    place = (np.arange(SHEET_PX) + 0.5) / SHEET_PX * count * size - 0.5
    first = np.floor(place).astype(int)
    share = (place - first)[:, None, None]
    rows = repeat[first % size] * (1 - share) + repeat[(first + 1) % size] * share
    share = share[:, 0][None]
    return rows[:, first % size] * (1 - share) + rows[:, (first + 1) % size] * share


def _twice(small: Array) -> Array:
    return _repeated(small[..., None], 1)[..., 0]
