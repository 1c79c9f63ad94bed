"""Boxes: packages, books, blocks."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.assets.procedural.form.cuboid import SIDES, Side, rounded_box
from probe.assets.procedural.form.hulls import hull
from probe.assets.procedural.parts.part import Painted, Piecewise, Triple
from probe.types import Array


class RoundedBox(Piecewise):
    """A box with rounded edges that stands on z = 0.

    Attributes:
        size: Metres along x, y, z.
        radius: Of its edges, metres.
        paint: Name of the paint of all sides that ``sides`` leaves out.
        sides: Names of the paints of single sides (top, bottom, front, back, left, right).
    """

    kind: Literal["box"]
    size: Triple
    radius: float = 0.001
    paint: str
    sides: dict[Side, str] = {}

    @property
    def paint_names(self) -> set[str]:
        return {self.sides.get(side, self.paint) for side in SIDES}

    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        del rng
        sides = rounded_box(np.array(self.size), self.radius)
        named = dict.fromkeys(SIDES, self.paint) | dict(self.sides)
        return [(sides[side], named[side]) for side in SIDES]

    def hulls(self, rng: np.random.Generator) -> list[Array]:
        return [hull(np.vstack([sheet.points.reshape(-1, 3) for sheet, _ in self.surfaces(rng)]))]
