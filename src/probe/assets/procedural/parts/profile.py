"""Profiles as they stand in the data, and what they are led around."""

from __future__ import annotations

import numpy as np

from probe.assets.procedural.form.curves import (
    arc_length,
    at_length,
)
from probe.assets.procedural.form.lathe import Base
from probe.assets.procedural.paint.data import Data
from probe.types import Array

Row = tuple[float, ...]
Rows = tuple[Row, ...]


class ProfileFootprint(Data):
    """What a profile is led around; see `form.lathe.Base`."""

    half: tuple[float, float] = (0, 0)
    corner: float = 1.0
    segments: int = 64

    @property
    def base(self) -> Base:
        return Base(self.half, self.corner, self.segments)


def corner_rows(rows: Rows) -> Array:
    """Corners (r, z) or (r, z, fillet) as an array with fillets, shape (n, 3)."""
    return np.array([[*row, 0.0][:3] for row in rows], dtype=float)


def cut_at(profile: Array, places: list[Array]) -> list[Array]:
    """The stretches of a profile between the points on it nearest to some places."""
    length = arc_length(profile)
    fine = np.union1d(np.linspace(0, length[-1], 600), length)
    points = at_length(profile, fine)
    cuts = [0.0, *(float(fine[np.argmin(((points - p) ** 2).sum(axis=1))]) for p in places)]
    found: list[Array] = []
    for low, high in zip(cuts, [*cuts[1:], float(length[-1])], strict=True):
        inside = length[(length > low + 1e-7) & (length < high - 1e-7)]
        found.append(at_length(profile, np.concatenate([[low], inside, [high]])))
    return found
