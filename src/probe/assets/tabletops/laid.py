"""Table tops laid of glazed tiles, and of sheet metal."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.tabletops.noise import SIZE, blend, cells, fractal, ramp
from probe.assets.tabletops.sheet import Colour, TableTile, Top, palette, rgb
from probe.types import Array


class Tiles(Top):
    """Glazed or clay tiles in rows.

    Attributes:
        colours: What they are made in; "chequered" takes the first two in turn.
        across, down: How many on a repeat; both even.
        bond: Rows shifted by half a tile, straight above one another, or chequered.
        variety: Difference in brightness between tiles, in grey levels.
        speckle: Grey levels of the glaze's unevenness.
        joint: Width of the joints, in tiles.
    """

    kind: Literal["tiles"]
    colours: tuple[Colour, ...]
    grout: Colour = "#cfcac0"
    across: int = 6
    down: int = 6
    bond: Literal["straight", "half", "chequered"] = "straight"
    variety: float = 4.0
    speckle: float = 2.0
    joint: float = 0.03
    tile_size: float = 0.6
    roughness: float = 0.25

    def paint(self, rng: np.random.Generator) -> TableTile:
        v, u = (np.indices((SIZE, SIZE)) + 0.5) / SIZE
        row = np.floor(v * self.down).astype(int)
        place_u = u * self.across + (0.5 * (row % 2) if self.bond == "half" else 0)
        column = np.floor(place_u).astype(int) % self.across
        tile = row * self.across + column
        count = self.across * self.down
        made = rng.integers(0, len(self.colours), count)
        which = (row + column) % 2 if self.bond == "chequered" else made[tile]
        tone = rng.normal(0, self.variety, count)[tile]
        glaze = fractal(rng, slope=1.3, scale=12)
        colour = palette(self.colours)[which] + (tone + self.speckle * glaze)[..., None]
        gap = np.minimum(_edge(place_u) / self.across, _edge(v * self.down) / self.down)
        half = self.joint / 2 / max(self.across, self.down)
        body = ramp(gap, half, half + 0.0025)
        cushion = ramp(gap, half, 4 * half + 0.006)
        sand = fractal(rng, slope=0.4, scale=120)
        colour = blend(rgb(self.grout) + 5 * sand[..., None], colour, body)
        height = 1.2e-3 * self.tile_size * cushion + 1e-5 * glaze
        return TableTile(colour, height, self.tile_size, self.roughness)


class SheetMetal(Top):
    """Sheet metal: brushed along u, hammered, or only worn.

    Attributes:
        brush: Grey levels of the brush marks.
        dents: Depth of the hammer's marks in metres.
        stain: Grey levels of tarnish.
    """

    kind: Literal["metal"]
    colour: Colour
    brush: float = 6.0
    dents: float = 0.0
    stain: float = 2.0
    tile_size: float = 0.6
    roughness: float = 0.4

    def paint(self, rng: np.random.Generator) -> TableTile:
        marks = fractal(rng, slope=0.2, scale=20, stretch=(60, 1))
        tarnish = fractal(rng, slope=1.6, scale=3)
        scratch = ramp(fractal(rng, slope=0.0, stretch=(30, 1.5), finest=300), 3.0, 4.0)
        _, distance, _ = cells(rng, 26)
        bowl: Array = np.minimum(distance, 0.6) ** 2
        shade = self.brush * marks + self.stain * tarnish + 10 * scratch
        if self.dents:
            shade = shade + 30 * (bowl - 0.12)
        height = 1e-6 * self.brush * marks + self.dents * bowl
        return TableTile(
            rgb(self.colour) + shade[..., None], height, self.tile_size, self.roughness, 1.0
        )


def _edge(place: Array) -> Array:
    """Distance to the nearest whole number, 0 to 0.5."""
    return np.abs(place - np.round(place))
