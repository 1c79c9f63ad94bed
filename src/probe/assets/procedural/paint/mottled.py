"""Skins, glazes, plastics: a body colour with patches, ends and spots. Knows no shapes."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.procedural.paint.canvas import Canvas, mix, shade, step
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.paint.data import Data
from probe.types import Array

Range = tuple[float, float]
Triple = tuple[float, float, float]


class Blotch(Data):
    """Soft patches of another colour: ``share`` of the surface, ``cell`` metres in size."""

    colour: str
    cell: float
    share: float = 0.3
    strength: float = 1.0
    soft: float = 0.5
    stretch: Triple = (1, 1, 1)

    def draw(self, picture: Array, canvas: Canvas, rng: np.random.Generator) -> Array:
        field = canvas.noise(rng, self.cell, self.stretch, octaves=3)
        level = float(np.quantile(field[::4, ::4], 1 - self.share))
        mask = step(field, level - self.soft, level + self.soft) * self.strength
        return mix(picture, rgb(self.colour), mask)


class Spots(Data):
    """Round spots, ``per_cm2`` of them with radii in metres."""

    colour: str
    per_cm2: float
    radius: Range
    strength: float = 0.7
    even: bool = False

    def draw(self, picture: Array, canvas: Canvas, rng: np.random.Generator) -> Array:
        mask = canvas.spots(rng, self.per_cm2, self.radius, self.even)
        return mix(picture, rgb(self.colour), mask * self.strength)


class Fade(Data):
    """Another colour towards one end along an axis, from place ``start`` to ``full`` (metres)."""

    colour: str
    start: float
    full: float
    axis: Literal["x", "y", "z", "r"] = "z"
    ragged: float = 0.0
    strength: float = 1.0

    def draw(self, picture: Array, canvas: Canvas, rng: np.random.Generator) -> Array:
        places = canvas.places()
        along = (
            np.hypot(places[..., 0], places[..., 1])
            if self.axis == "r"
            else places[..., "xyz".index(self.axis)]
        )
        if self.ragged > 0:
            along = along + self.ragged * canvas.noise(rng, 0.008, octaves=3)
        mask = np.clip((along - self.start) / (self.full - self.start), 0, 1)
        return mix(picture, rgb(self.colour), mask * mask * (3 - 2 * mask) * self.strength)


class Seam(Data):
    """The one closed seam of a tennis ball, of half width ``seam`` in metres."""

    colour: str
    seam: float

    def draw(self, picture: Array, canvas: Canvas, rng: np.random.Generator) -> Array:
        del rng
        places = canvas.places()
        low, high = places.min(axis=(0, 1)), places.max(axis=(0, 1))
        x, y, z = np.moveaxis(places - (low + high) / 2, -1, 0) / ((high - low).max() / 2)
        # A saddle z = x^2 - y^2 cuts a sphere in a curve that swings up and down twice.
        away = np.abs(z - (x * x - y * y)) / np.sqrt(1 + 4 * (x * x + y * y))
        width = self.seam / ((high - low).max() / 2)
        return mix(picture, rgb(self.colour), 1 - step(away, width * 0.7, width))


class Mottled(Data):
    """A body colour with patches, ends and spots: paint, glaze, peel, skin, wax, clay.

    Attributes:
        colour: Of the body.
        tone: Strength of slow changes of brightness.
        grain: Strength of fine grain.
        layers: Drawn in this order on the body colour.
    """

    look: Literal["mottled"] = "mottled"
    colour: str
    tone: float = 0.03
    grain: float = 0.012
    layers: tuple[Blotch | Fade | Spots | Seam, ...] = ()

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        picture = canvas.fill(rgb(self.colour))
        for layer in self.layers:
            picture = layer.draw(picture, canvas, rng)
        slow = canvas.noise(rng, 0.03, octaves=2) * self.tone
        fine = rng.standard_normal(canvas.shape, dtype=np.float32) * self.grain
        return shade(picture, slow + fine)
