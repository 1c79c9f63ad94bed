"""What all parts share: a place, surfaces with the names of their paints, convex pieces."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

import numpy as np

from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.paint.data import Data
from probe.types import Array, Pose, quaternion_of

Triple = tuple[float, float, float]
Painted = tuple[Sheet, str]  # a surface and the name of its paint


class PartPlacement(Data):
    """Where a part goes: turned about x, then y, then z (degrees), then shifted (metres)."""

    at: Triple = (0, 0, 0)
    turn: Triple = (0, 0, 0)

    @property
    def pose(self) -> Pose:
        rotation = np.eye(3)
        for axis, degrees in enumerate(self.turn):
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            j, k = (axis + 1) % 3, (axis + 2) % 3
            once = np.eye(3)
            once[j, j], once[j, k], once[k, j], once[k, k] = c, -s, s, c
            rotation = once @ rotation
        return Pose.of(np.asarray(self.at), quaternion_of(rotation))


class Copies(Data):
    """The same part several times: each shifted (metres) and turned about z (degrees) further."""

    count: int = 1
    step: Triple = (0, 0, 0)
    turn: float = 0

    @property
    def poses(self) -> list[Pose]:
        steps = [(k * np.asarray(self.step), k * self.turn) for k in range(self.count)]
        return [PartPlacement(at=tuple(at), turn=(0, 0, turn)).pose for at, turn in steps]


class Piecewise(Data, ABC):
    """A part that goes somewhere, once or several times.

    Attributes:
        solid: False if it is for the eye alone and has no convex pieces.
    """

    place: PartPlacement = PartPlacement()
    copies: Copies = Copies()
    solid: bool = True

    @property
    @abstractmethod
    def paint_names(self) -> set[str]:
        """Names of all paints that it needs."""

    @abstractmethod
    def surfaces(self, rng: np.random.Generator) -> list[Painted]:
        """Its surfaces before they are put in place."""

    @abstractmethod
    def hulls(self, rng: np.random.Generator) -> list[Array]:
        """Its convex pieces before they are put in place; the same ``rng`` as for surfaces."""

    def placed_surfaces(self, rng: np.random.Generator) -> list[Painted]:
        once = [(sheet.moved(self.place.pose), paint) for sheet, paint in self.surfaces(rng)]
        if self.copies.count == 1:
            return once
        return [(sheet.moved(pose), paint) for pose in self.copies.poses for sheet, paint in once]

    def placed_hulls(self, rng: np.random.Generator) -> list[Array]:
        if not self.solid:
            return []
        once = [self.place.pose.apply(corners) for corners in self.hulls(rng)]
        if self.copies.count == 1:
            return once
        return [pose.apply(corners) for pose in self.copies.poses for corners in once]
