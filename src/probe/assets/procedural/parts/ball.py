"""Balls and ellipsoids: heads, bodies, berries, knobs."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.assets.procedural.form.hulls import hull
from probe.assets.procedural.form.lathe import Base, turn
from probe.assets.procedural.parts.part import Painted, Piecewise, Triple
from probe.types import Array


class Ball(Piecewise):
    """An ellipsoid about the origin.

    Attributes:
        size: Diameters along x, y, z, metres.
        segments: Steps around a full turn.
    """

    kind: Literal["ball"]
    size: Triple
    segments: int = 32
    paint: str

    @property
    def paint_names(self) -> set[str]:
        return {self.paint}

    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        del rng
        angle = np.linspace(-math.pi / 2, math.pi / 2, self.segments // 2 + 1)
        profile = 0.5 * np.column_stack([np.cos(angle), np.sin(angle)])
        profile[[0, -1], 0] = 0  # the poles lie on the axis exactly
        (sheet,) = turn([profile], Base(segments=self.segments), [False])
        return [(sheet.stretched(np.array(self.size)), self.paint)]

    def hulls(self, rng: np.random.Generator) -> list[Array]:
        return [hull(self.surfaces(rng)[0][0].points.reshape(-1, 3))]
