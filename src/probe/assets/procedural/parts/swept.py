"""Bars along a path: handles, blades, bananas."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.assets.procedural.form.curves import (
    resampled,
    smoothed,
)
from probe.assets.procedural.form.hulls import hull
from probe.assets.procedural.form.sweep import section, sweep
from probe.assets.procedural.parts.part import Painted, Piecewise, Triple
from probe.types import Array

STEP = 0.003  # metres between points of a splined path


class Swept(Piecewise):
    """A bar along a path: handle, blade, fruit.

    Attributes:
        path: Points in metres.
        size: Full width and height at each point of the path, metres; one row for all.
        smooth: Whether splines are laid through path and sizes.
        exponent: Of the superelliptic section: 2 round, 8 nearly square.
        facets: Number of flat sides of the section instead, if over 0.
        up: Direction of the height.
        fillet: Radius of the rounded ends, metres.
        pieces: How many convex pieces it is cut into along its path.
    """

    kind: Literal["swept"]
    path: tuple[Triple, ...]
    size: tuple[tuple[float, float], ...]
    smooth: bool = False
    exponent: float = 2.0
    facets: int = 0
    up: Triple = (0, 0, 1)
    fillet: float = 0.002
    columns: int = 33
    pieces: int = 1
    paint: str

    @property
    def paint_names(self) -> set[str]:
        return {self.paint}

    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        del rng
        rows = self.size if len(self.size) > 1 else self.size * len(self.path)
        both = np.hstack([np.array(self.path), np.array(rows) / 2])
        both = smoothed(both, STEP) if self.smooth else resampled(both, 0.006)
        outline, up = self._outline(), np.array(self.up)
        return [(sweep(both[:, :3], both[:, 3:], outline, up, self.fillet), self.paint)]

    def hulls(self, rng: np.random.Generator) -> list[Array]:
        points = self.surfaces(rng)[0][0].points
        cuts = np.linspace(0, len(points) - 1, self.pieces + 1).round().astype(int)
        pairs = zip(cuts[:-1], cuts[1:], strict=True)
        return [hull(points[low : high + 1].reshape(-1, 3)) for low, high in pairs]

    def _outline(self) -> Array:
        if not self.facets:
            return section(self.exponent, self.columns)
        angle = np.linspace(0, math.tau, self.columns)
        flat = math.pi / self.facets
        # A polygon whose corners are rounded by half a step towards the circle.
        radius = math.cos(flat) / np.cos((angle + flat) % (2 * flat) - flat)
        radius = np.minimum(radius, 0.5 * (radius + math.cos(flat) ** 0.5))
        return np.column_stack([np.cos(angle), np.sin(angle)]) * radius[:, None]
