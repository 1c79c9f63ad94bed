"""Full solids of revolution: cans, jars, fruit."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from probe.assets.procedural.form.curves import filleted, smoothed_between_poles
from probe.assets.procedural.form.hulls import hull, slices
from probe.assets.procedural.form.lathe import turn
from probe.assets.procedural.form.sheet import Sheet, grid_normals
from probe.assets.procedural.paint.data import Data
from probe.assets.procedural.parts.part import Painted, Piecewise
from probe.assets.procedural.parts.profile import (
    ProfileFootprint,
    Rows,
    corner_rows,
    cut_at,
)
from probe.types import Array

STEP = 0.003  # metres between points of a splined profile


class Band(Data):
    """A stretch of a profile with its own paint.

    Attributes:
        paint: Name of the paint.
        to: Number of the profile's corner (from 0) at which it ends; None for the end.
        above: Whether the picture is laid on from above instead of wrapped around.
    """

    paint: str
    to: int | None = None
    above: bool = False


class Lumps(Data):
    """What keeps grown and kneaded things from being round.

    Attributes:
        amount: Height of the lumps, metres.
        cell: Their size, metres.
        ribs: Number of ribs around the axis.
        depth: Height of the ribs, metres.
    """

    amount: float = 0.0
    cell: float = 0.03
    ribs: int = 0
    depth: float = 0.0

    def on(self, sheet: Sheet, rng: np.random.Generator) -> Sheet:
        """The sheet with lumps."""
        waves = rng.standard_normal((8, 3))
        waves *= math.tau / self.cell / np.linalg.norm(waves, axis=1, keepdims=True)
        phases = rng.uniform(0, math.tau, 8)
        height = self.amount * np.sin(sheet.points @ waves.T + phases).mean(axis=-1) * 2
        around = np.arctan2(sheet.points[..., 1], sheet.points[..., 0])
        off_axis = np.clip(np.hypot(sheet.points[..., 0], sheet.points[..., 1]) / 0.015, 0, 1)
        height = height + self.depth * np.cos(self.ribs * around) * off_axis
        points = sheet.points + sheet.normals * height[..., None]
        return Sheet(points, grid_normals(points), sheet.uvs, sheet.extent, sheet.plane)


class Turned(Piecewise):
    """A full solid of revolution.

    Attributes:
        profile: Corners (r, z, fillet), from the bottom of the axis to its top.
        smooth: Whether a spline is laid through the corners instead of rounded lines.
        bands: Paints from the bottom to the top.
        cuts: Heights at which its collision shape is cut.
    """

    kind: Literal["turned"]
    profile: Rows
    smooth: bool = False
    bands: tuple[Band, ...]
    footprint: ProfileFootprint = ProfileFootprint()
    cuts: tuple[float, ...] = ()
    lumps: Lumps | None = None

    @property
    def paint_names(self) -> set[str]:
        return {band.paint for band in self.bands}

    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        corners, profile = corner_rows(self.profile), self._curve()
        curves = cut_at(profile, [corners[b.to, :2] for b in self.bands if b.to is not None])
        sheets = turn(curves, self.footprint.base, [band.above for band in self.bands])
        if self.lumps is not None:
            sheets = [self.lumps.on(sheet, rng) for sheet in sheets]
        return list(zip(sheets, (band.paint for band in self.bands), strict=True))

    def hulls(self, rng: np.random.Generator) -> list[Array]:
        if self.lumps is not None:
            points = np.vstack([sheet.points.reshape(-1, 3) for sheet, _ in self.surfaces(rng)])
            return _slabs(points, list(self.cuts))
        return slices(self._curve(), self.footprint.base, list(self.cuts))

    def _curve(self) -> Array:
        corners = corner_rows(self.profile)
        if not self.smooth:
            return filleted(corners)
        curve = smoothed_between_poles(corners[:, :2], STEP)
        curve[:, 0] = np.maximum(curve[:, 0], 0)
        return curve


def _slabs(points: Array, cuts: list[float]) -> list[Array]:
    """Hulls of the points between heights, overlapping a little so that no gap is left."""
    bounds = zip([-np.inf, *cuts], [*cuts, np.inf], strict=True)
    heights = points[:, 2]
    return [hull(points[(heights >= a - STEP) & (heights <= b + STEP)]) for a, b in bounds]
