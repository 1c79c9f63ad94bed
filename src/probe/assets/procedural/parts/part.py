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


class Place(Data):
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


class Piecewise(Data, ABC):
    """A part that goes somewhere.

    Attributes:
        solid: False if it is for the eye alone and has no convex pieces.
    """

    place: Place = Place()
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
        pose = self.place.pose
        return [(sheet.moved(pose), paint) for sheet, paint in self.surfaces(rng)]

    def placed_hulls(self, rng: np.random.Generator) -> list[Array]:
        pose = self.place.pose
        return [pose.apply(corners) for corners in self.hulls(rng)] if self.solid else []
