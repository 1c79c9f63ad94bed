"""The picture of one surface while it is drawn, with the place in space of each pixel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import map_coordinates

from probe.assets.procedural.form.sheet import Sheet
from probe.types import Array

LATTICE = 24  # cells of the repeating random lattice that noise is drawn from
COARSE = 4  # pixels a step of the grid on which spots are placed
MOST_SPOTS = 20000
FINE = 3.0  # pixels a lattice cell at which noise is computed; coarser noise is blown up


@dataclass(frozen=True, eq=False)
class Canvas:
    """What a paint needs to know of the surface that it covers.

    Attributes:
        sheet: The surface.
        width_px, height_px: Size of its picture.
        px_per_m: Pixels a metre along the picture's widest row and its columns.
    """

    sheet: Sheet
    width_px: int
    height_px: int
    px_per_m: float

    @property
    def shape(self) -> tuple[int, int]:
        return (self.height_px, self.width_px)

    def fill(self, colour: Array) -> Array:
        """A picture of one colour, float32, shape (h, w, 3)."""
        return np.broadcast_to(colour.astype(np.float32), (*self.shape, 3)).copy()

    def across(self) -> Array:
        """Place of each column in metres from the left, float32, shape (1, w)."""
        return ((np.arange(self.width_px, dtype=np.float32) + 0.5) / self.px_per_m)[None]

    def down(self) -> Array:
        """Place of each row in metres from the top, float32, shape (h, 1)."""
        return ((np.arange(self.height_px, dtype=np.float32) + 0.5) / self.px_per_m)[:, None]

    def places(self, step: int = 1) -> Array:
        """Where every ``step``-th pixel lies in space, metres, float32, shape (h', w', 3)."""
        return self.sheet.map(max(2, -(-self.width_px // step)), max(2, -(-self.height_px // step)))

    def noise(
        self,
        rng: np.random.Generator,
        cell: float,
        stretch: tuple[float, float, float] = (1, 1, 1),
        octaves: int = 1,
    ) -> Array:
        """Random field in space, seen on the surface: no seams and no pinching at poles.

        Args:
            rng: Source of the field.
            cell: Size of its features in metres.
            stretch: Factors by which features are longer along x, y, z.
            octaves: Layers, each half as large and half as strong as the one before.

        Returns:
            About -1 to 1 with mean near 0, float32, shape (h, w).
        """
        total = np.zeros(self.shape, dtype=np.float32)
        for octave in range(octaves):
            lattice = rng.standard_normal((LATTICE,) * 3).astype(np.float32)
            size = np.asarray(stretch, dtype=np.float32) * cell / 2**octave
            pixels = float(size.min()) * self.px_per_m
            places = self.places(int(np.clip(pixels / FINE, 2, 16)))
            shift = rng.uniform(0, LATTICE, 3).astype(np.float32)
            where = np.moveaxis(places / size + shift, -1, 0)
            field = map_coordinates(lattice, where, order=1, mode="grid-wrap")
            total += self._blown_up(field) * 0.5**octave
        return total * 0.8

    def _blown_up(self, field: Array) -> Array:
        if field.shape == self.shape:
            return field
        image = Image.fromarray(field.astype(np.float32))
        size = (self.width_px, self.height_px)
        return np.asarray(image.resize(size, Image.Resampling.BICUBIC))

    def spots(
        self,
        rng: np.random.Generator,
        per_cm2: float,
        radius: tuple[float, float],
        even: bool = False,
    ) -> Array:
        """Mask of round spots scattered over the surface, 0-1, float32, shape (h, w).

        Args:
            rng: Source of places and sizes.
            per_cm2: Mean number a square centimetre.
            radius: Smallest and largest, metres.
            even: Whether they keep their distance from each other.
        """
        places = self.places(COARSE)
        along = np.linalg.norm(np.gradient(places, axis=1), axis=-1) / COARSE  # metres a pixel
        upward = np.linalg.norm(np.gradient(places, axis=0), axis=-1) / COARSE
        area = along * upward * COARSE**2
        count = int(rng.poisson(min(float(area.sum()) * 1e4 * per_cm2, MOST_SPOTS)))
        cells = np.cumsum(area.ravel()) / area.sum()
        picked = np.searchsorted(cells, rng.uniform(size=count * (8 if even else 1)))
        picked = np.minimum(picked, area.size - 1)
        if even:
            picked = picked[_apart(places.reshape(-1, 3)[picked], 0.0083 / per_cm2**0.5)]
        row, column = np.unravel_index(picked, area.shape)
        size = rng.uniform(*radius, len(picked))
        half_w = np.minimum(size / np.maximum(along[row, column], 1e-6), self.width_px / 3)
        half_h = size / np.maximum(upward[row, column], 1e-6)
        jitter = rng.uniform(0, COARSE, (2, len(picked)))
        centre = np.array([column, row]) * COARSE + jitter
        return self._ellipses(centre, np.array([half_w, half_h]))

    def _ellipses(self, centre: Array, half: Array) -> Array:
        """Smooth mask of ellipses given by centres and half axes in pixels, shape (2, n) each."""
        image = Image.new("L", (self.width_px * 2, self.height_px * 2))
        pen = ImageDraw.Draw(image)
        for box in np.vstack([centre - half, centre + half]).T * 2:
            pen.ellipse([float(v) for v in box], fill=255)
        return np.asarray(image.reduce(2), dtype=np.float32) / 255


def _apart(points: Array, distance: float) -> Array:
    """Indices of points, taken in order, that keep a distance from all taken before."""
    taken: list[int] = []
    free = np.ones(len(points), dtype=bool)
    for k, point in enumerate(points):
        if free[k]:
            taken.append(k)
            free &= np.linalg.norm(points - point, axis=1) > distance
    return np.array(taken, dtype=int)


def mix(under: Array, over: Array, share: Array | float) -> Array:
    """Blend of two pictures or colours; ``share`` of the second, a number or shape (h, w)."""
    weight = share if isinstance(share, float) else np.asarray(share)[..., None]
    return under * (1 - weight) + over * weight


def shade(picture: Array, factor: Array) -> Array:
    """Picture times (1 + factor), factor of shape (h, w)."""
    return picture * (1 + factor)[..., None]


def step(values: Array, low: float, high: float) -> Array:
    """Smooth rise from 0 at ``low`` to 1 at ``high``."""
    t = np.clip((values - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
