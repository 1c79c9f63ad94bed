"""Regular patterns of two colours: stripes, bands, checks, dots, diamonds. Knows no shapes."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.procedural.paint.canvas import Canvas, mix, shade, step
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.paint.data import Data
from probe.types import Array

EDGE_PX = 0.7  # half the width of the blur at an edge


class Pattern(Data):
    """One colour on another in a pattern that closes around what is turned.

    Attributes:
        figure: Stripes run down the picture, bands across.
        colour: Of the ground.
        second: Of the figure.
        pitch: Width of one repeat, metres.
        share: Of a repeat's width that a stripe, band or dot takes.
        grain: Strength of fine grain.
    """

    look: Literal["pattern"] = "pattern"
    figure: Literal["stripes", "bands", "checks", "dots", "diamonds"]
    colour: str
    second: str
    pitch: float = 0.012
    share: float = 0.5
    grain: float = 0.01

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        across, repeat_px = self._repeats(canvas.width_px, canvas)
        down, _ = self._repeats(canvas.height_px, canvas)
        x = (np.arange(canvas.width_px, dtype=np.float32)[None] + 0.5) / canvas.width_px * across
        y = (np.arange(canvas.height_px, dtype=np.float32)[:, None] + 0.5) / canvas.height_px * down
        inside = np.broadcast_to(self._inside(x, y), canvas.shape)
        blur = EDGE_PX / repeat_px
        mask = step(inside, -blur, blur) if self.figure != "checks" else inside
        picture = mix(rgb(self.colour), rgb(self.second), mask)
        fine = rng.standard_normal(canvas.shape, dtype=np.float32) * self.grain
        return shade(picture, fine + canvas.noise(rng, 0.03, octaves=2) * 0.02)

    def _repeats(self, size_px: int, canvas: Canvas) -> tuple[int, float]:
        """Whole number of repeats along one side of the picture, and pixels of each."""
        count = max(1, round(size_px / canvas.px_per_m / self.pitch))
        return count, size_px / count

    def _inside(self, x: Array, y: Array) -> Array:
        """How far a pixel lies inside the figure, in repeats; of checks, how much they cover."""
        if self.figure == "checks":
            return (_saw(x) < self.share / 2) * 0.5 + (_saw(y) < self.share / 2) * 0.5
        if self.figure == "stripes":
            return self.share / 2 - _saw(x)
        if self.figure == "bands":
            return self.share / 2 - _saw(y)
        if self.figure == "diamonds":
            return self.share - (_saw(x) + _saw(y))
        # Dots stand in rows, every other one shifted by half a repeat: two grids.
        one, other = np.hypot(_saw(x), _saw(y)), np.hypot(_saw(x + 0.5), _saw(y + 0.5))
        return self.share / 2 - np.minimum(one, other)


def _saw(values: Array) -> Array:
    """Distance to the middle of a repeat, 0 to 0.5."""
    return np.abs(values - np.floor(values) - 0.5)
