"""Turned things with a cavity: bowls, mugs, pans, hats; and rings."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.assets.procedural.form.curves import (
    arc_length,
    at_length,
    distinct,
    filleted,
)
from probe.assets.procedural.form.hulls import shell
from probe.assets.procedural.form.lathe import turn
from probe.assets.procedural.parts.part import Painted, Piecewise
from probe.assets.procedural.parts.profile import (
    ProfileFootprint,
    Rows,
    corner_rows,
    cut_at,
)
from probe.types import Array

RIM_STEPS = 5  # points of the half circle over a rim


class Hollow(Piecewise):
    """A turned thing with a cavity: bowl, mug, pan, hat; or a ring if no profile starts at 0.

    Attributes:
        outer: Corners (r, z, fillet) of the outside, from the bottom's middle to the rim.
        inner: Likewise of the inside.
        outside, inside: Names of their paints.
        lip: Name of the rim's paint; the outside's if empty.
        lip_width: How far the rim's paint reaches down on either side, metres.
        bands, sectors: How finely its collision shape is cut.
    """

    kind: Literal["hollow"]
    outer: Rows
    inner: Rows
    outside: str
    inside: str
    lip: str = ""
    lip_width: float = 0.0015
    footprint: ProfileFootprint = ProfileFootprint()
    bands: int = 2
    sectors: int = 14

    @property
    def paint_names(self) -> set[str]:
        return {self.outside, self.inside, self.lip or self.outside}

    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        del rng
        outer, inner = filleted(corner_rows(self.outer)), filleted(corner_rows(self.inner))
        outer_wall, outer_lip = _near_end(outer, self.lip_width)
        inner_wall, inner_lip = _near_end(inner, self.lip_width)
        lip = distinct(np.vstack([outer_lip, _rim(outer[-1], inner[-1]), inner_lip[::-1]]))
        inward = inner_wall[::-1]
        if inner[0, 0] > 1e-6:
            inward = distinct(np.vstack([inward, outer[:1]]))
        sheets = turn([outer_wall, lip, inward], self.footprint.base, [False] * 3)
        return list(zip(sheets, (self.outside, self.lip or self.outside, self.inside), strict=True))

    def hulls(self, rng: np.random.Generator) -> list[Array]:
        del rng
        outer, inner = filleted(corner_rows(self.outer)), filleted(corner_rows(self.inner))
        rim = _rim(outer[-1], inner[-1])[: RIM_STEPS // 2 + 1]
        return shell(outer, inner, rim, self.footprint.base, self.bands, self.sectors)


def _near_end(profile: Array, reach: float) -> list[Array]:
    """A profile in two: what lies further than ``reach`` from its end, and the rest."""
    cut = arc_length(profile)[-1] - reach
    return cut_at(profile, [at_length(profile, np.array([cut]))[0]])


def _rim(outer: Array, inner: Array) -> Array:
    """Half circle over a rim, from its outer to its inner edge, shape (n, 2)."""
    middle, spoke = (outer + inner) / 2, (outer - inner) / 2
    ahead = np.array([-spoke[1], spoke[0]])
    angle = np.linspace(0, math.pi, RIM_STEPS + 2)[1:-1, None]
    return middle + np.cos(angle) * spoke + np.sin(angle) * ahead
