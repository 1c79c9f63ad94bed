"""Materials with a grain: wood, metal, cloth, stacked paper. Knows no shapes."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.procedural.paint.canvas import Canvas, mix, shade, step
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.paint.data import Data
from probe.types import Array

Range = tuple[float, float]


class Wood(Data):
    """Solid wood: rings about a far axis, pores along it.

    Attributes:
        colour: Of the early wood.
        dark: Of the late wood and pores.
        ring: Mean distance of rings, metres.
        axis: Direction of the grain.
        contrast: Of the rings.
    """

    look: Literal["wood"] = "wood"
    colour: str
    dark: str
    ring: float = 0.006
    axis: Literal["x", "y", "z"] = "x"
    contrast: float = 0.55

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        axis = "xyz".index(self.axis)
        others = [k for k in range(3) if k != axis]
        places = canvas.places()
        long = [12.0 if k == axis else 1.0 for k in range(3)]
        stretch = (long[0], long[1], long[2])
        heart = rng.uniform(0.04, 0.08, 2)
        radius = np.hypot(places[..., others[0]] - heart[0], places[..., others[1]] + heart[1])
        rings = radius / self.ring + 0.35 * canvas.noise(rng, 0.025, stretch, octaves=2)
        phase = rings - np.floor(rings)
        late = step(phase, 0.25, 0.9) * (1 - step(phase, 0.93, 1.0))
        picture = mix(rgb(self.colour), rgb(self.dark), late * self.contrast)
        pores = step(canvas.noise(rng, 0.0007, stretch), 0.9, 1.8)
        picture = mix(picture, rgb(self.dark), pores * 0.45)
        return shade(picture, canvas.noise(rng, 0.02, stretch, octaves=3) * 0.07)


class Metal(Data):
    """Metal with brush marks along an axis ("z" also runs around what was turned).

    Attributes:
        colour: Of the metal.
        brush: Strength of the marks.
        stain: Strength of dull patches.
        along: Direction in which the marks run.
    """

    look: Literal["metal"] = "metal"
    colour: str = "silver"
    brush: float = 0.05
    stain: float = 0.06
    along: Literal["around", "x", "y", "z"] = "around"

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        if self.along == "around":
            rows = rng.standard_normal((canvas.height_px, 1), dtype=np.float32)
            marks = rows + 0.5 * canvas.noise(rng, 0.004)
        else:
            long = [40.0 if self.along == k else 1.0 for k in "xyz"]
            marks = canvas.noise(rng, 0.0006, (long[0], long[1], long[2]), octaves=2)
        dull = canvas.noise(rng, 0.02, octaves=4)
        scratches = step(canvas.noise(rng, 0.0012, (9, 1.5, 1.5)), 1.7, 2.4) * 0.08
        picture = canvas.fill(rgb(self.colour))
        return shade(picture, marks * self.brush + dull * self.stain + scratches)


class Weave(Data):
    """Threads, straws or canes that cross over and under each other.

    Attributes:
        colour: Of the threads along the rows.
        other: Of the threads down the columns; the same if empty.
        thread: Width and height of one crossing, metres.
        depth: How dark the gaps are, 0-1.
    """

    look: Literal["weave"] = "weave"
    colour: str
    other: str = ""
    thread: Range
    depth: float = 0.6
    uneven: float = 0.12

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        columns = max(2, 2 * round(canvas.width_px / canvas.px_per_m / self.thread[0] / 2))
        rows = max(1, round(canvas.height_px / canvas.px_per_m / self.thread[1]))
        x = canvas.across() * canvas.px_per_m / canvas.width_px * columns
        y = canvas.down() * canvas.px_per_m / canvas.height_px * rows
        wobble = canvas.noise(rng, self.thread[1] * 2) * 0.1
        i, j = np.floor(x).astype(int), np.floor(y).astype(int)
        over = (i + j) % 2 == 0
        fx, fy = x - i - 0.5, y - j - 0.5 + wobble
        # The thread on top bulges across its own width and dips at both ends of the crossing.
        height = np.where(
            over,
            np.cos(np.pi * fy) * (0.55 + 0.45 * np.cos(np.pi * fx)),
            np.cos(np.pi * fx) * (0.55 + 0.45 * np.cos(np.pi * fy)),
        ).astype(np.float32)
        threads = rng.standard_normal((2, max(rows, columns) + 2)).astype(np.float32)
        tint = (threads[0, j] * over + threads[1, i] * ~over) * self.uneven
        tops = mix(rgb(self.other or self.colour), rgb(self.colour), over.astype(np.float32))
        fibre = canvas.noise(rng, 0.0012, octaves=2) * 0.06
        return shade(tops, (np.clip(height, 0, 1) - 1) * self.depth + tint + fibre)


class Layers(Data):
    """Edges of stacked sheets: the pages of a book, plies, a deck of cards."""

    look: Literal["layers"] = "layers"
    colour: str
    gap: float = 0.0005
    depth: float = 0.25
    upright: bool = False

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        size = canvas.width_px if self.upright else canvas.height_px
        count = max(4, round(size / canvas.px_per_m / self.gap))
        at = np.linspace(0, count - 1, size)
        lines = np.interp(at, np.arange(count), rng.uniform(-1, 0, count)).astype(np.float32)
        lines = lines[None, :] if self.upright else lines[:, None]
        waves = canvas.noise(rng, 0.01, octaves=3) * 0.05
        return shade(canvas.fill(rgb(self.colour)), lines * self.depth + waves)
