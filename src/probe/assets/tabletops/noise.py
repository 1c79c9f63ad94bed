"""Noise on a square that repeats without a seam. Knows no materials."""

from __future__ import annotations

import numpy as np

from probe.types import Array

SIZE = 1024
"""Pixels along an edge of every table texture."""


def fractal(
    rng: np.random.Generator,
    *,
    slope: float = 1.0,
    scale: float = 1.0,
    stretch: tuple[float, float] = (1.0, 1.0),
    finest: float = SIZE / 2,
) -> Array:
    """Gaussian noise with a power-law spectrum, mean 0 and deviation 1, shape (SIZE, SIZE).

    White noise filtered in the Fourier domain, hence periodic (Voss, "Random Fractal
    Forgeries", 1985).

    Args:
        rng: Source of randomness.
        slope: Amplitude falls as frequency to the minus this; 0 is white, 2 cloudy.
        scale: Waves an edge below which amplitude no longer grows.
        stretch: Factors on the wavelength along u (columns) and v (rows).
        finest: Waves an edge beyond which there are none.
    """
    waves = np.fft.fftfreq(SIZE, 1 / SIZE)
    frequency = np.hypot(waves[None, :] * stretch[0], waves[:, None] * stretch[1])
    amplitude = np.maximum(frequency, scale) ** -slope
    amplitude = amplitude * np.exp(-((frequency / finest) ** 2))
    amplitude[0, 0] = 0.0
    spectrum = np.fft.fft2(rng.standard_normal((SIZE, SIZE))) * amplitude
    noise = np.fft.ifft2(spectrum).real
    return noise / noise.std()


def cells(rng: np.random.Generator, across: int, warp: float = 0.0) -> tuple[Array, Array, Array]:
    """Periodic Voronoi cells (Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996).

    Args:
        rng: Source of randomness.
        across: Cells along an edge; each has its seed somewhere in one square of a grid.
        warp: How far, in cells, outlines stray from straight lines.

    Returns:
        Number of the nearest seed (0 to across squared), the distance to it, and the distance
        to the second nearest minus that, both in cells; shape (SIZE, SIZE) each.
    """
    seeds = rng.random((across, across, 2))
    v, u = (np.indices((SIZE, SIZE)) + 0.5) * across / SIZE
    if warp:
        v = v + warp * fractal(rng, slope=2.0, scale=across, finest=3 * across)
        u = u + warp * fractal(rng, slope=2.0, scale=across, finest=3 * across)
    row, column = np.floor(v).astype(int), np.floor(u).astype(int)
    number = np.zeros((SIZE, SIZE), dtype=int)
    first, second = np.full((SIZE, SIZE), np.inf), np.full((SIZE, SIZE), np.inf)
    for down, right in np.indices((3, 3)).reshape(2, -1).T - 1:
        i, j = (row + down) % across, (column + right) % across
        seed = seeds[i, j]
        far = np.hypot(row + down + seed[..., 0] - v, column + right + seed[..., 1] - u)
        nearer = far < first
        second = np.where(nearer, first, np.minimum(second, far))
        first = np.where(nearer, far, first)
        number = np.where(nearer, i * across + j, number)
    return number, first, second - first


def moved(image: Array, along_v: Array, along_u: Array) -> Array:
    """An image read at places displaced by whole pixels, wrapping around, shape (SIZE, SIZE)."""
    v, u = np.indices((SIZE, SIZE))
    rows = (v + np.round(along_v).astype(int)) % SIZE
    columns = (u + np.round(along_u).astype(int)) % SIZE
    return image[rows, columns]


def blend(first: Array, second: Array, share: Array) -> Array:
    """Colours between two, shape (SIZE, SIZE, 3), by a share from 0 to 1 for each pixel."""
    weight = np.clip(share, 0.0, 1.0)[..., None]
    return np.asarray(first) * (1 - weight) + np.asarray(second) * weight


def ramp(values: Array, low: float, high: float) -> Array:
    """Smoothly from 0 at `low` to 1 at `high` (or the other way round), as smoothstep."""
    share = np.clip((values - low) / (high - low), 0.0, 1.0)
    return share * share * (3 - 2 * share)


def normals_of(height: Array, texel: float) -> Array:
    """Normal map in the OpenGL convention (green up), uint8, shape (h, w, 3).

    Args:
        height: Metres, periodic, shape (h, w).
        texel: Metres along a pixel's edge.
    """
    slope_u: Array = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) / (2 * texel)
    slope_v: Array = (np.roll(height, -1, axis=0) - np.roll(height, 1, axis=0)) / (2 * texel)
    normal: Array = np.stack([-slope_u, slope_v, np.ones(height.shape)], axis=-1)
    normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.asarray(np.round((normal + 1) * 127.5), dtype=np.uint8)
