"""Covers over things that lie along the picture's edges; each candidate has its own companions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.object_selection import ObjectSelection
from probe.generation.stage import Layer, Poses, Stage
from probe.generation.twins import Lay, build_nest, right_above
from probe.world.model import Post

_ASKEW = 0.1
"""Radians by which a thing may be turned from an edge: its box is then about as long as it is."""


@dataclass(frozen=True, eq=False)
class EdgewiseNests:
    """Covers on their places, over a candidate and its companions.

    Attributes:
        cast: Who plays.
        stage: Made of the cast's specs.
        posts: Where each cover stands.
        places: Covers, by number from 0, of the candidates and then of their companions.
        companions: Of each candidate, instances on the stage: one for each further cover.
        laid: What has been laid: poses, by the hidden instance and the cover's number.
    """

    cast: ObjectSelection
    stage: Stage
    posts: Sequence[Post]
    places: Sequence[int]
    companions: Sequence[tuple[int, ...]]
    laid: dict[tuple[int, int], Poses] = field(default_factory=dict[tuple[int, int], Poses])

    def nest(self, target: int, rng: np.random.Generator) -> Poses:
        """All covers, with this candidate and its companions beneath; see twins.Nest.

        Raises:
            Rejected: One of the covers doesn't hide what is beneath it.
        """
        poses: Poses = {}
        items = (target, *self.companions[target - 1])
        for item, number in zip(items, self.places, strict=True):
            if (item, number) not in self.laid:
                lay = self._along_edges(item, number)
                nest = build_nest(self.stage, item, lay, self.posts[number], rng)
                self.laid[item, number] = nest
            poses |= self.laid[item, number]
        return poses

    def pairs_of(self, candidate: int) -> Sequence[tuple[int, int]]:
        """See CoveredPairs."""
        items = (candidate + 1, *self.companions[candidate])
        covers = (self.cast.covering[number] for number in self.places)
        return tuple(zip(items, covers, strict=True))

    def _along_edges(self, item: int, number: int) -> Lay:
        """Lays a cover right above a thing that lies along an edge of the picture."""
        cover = self.cast.covers[number]
        above = right_above(self.cast.covering[number], cover)

        def lay(hidden: ObjectSpec, rng: np.random.Generator) -> list[Layer]:
            (layer,) = above(hidden, rng)
            yaw = math.pi / 2 * int(rng.integers(4)) + float(rng.uniform(-_ASKEW, _ASKEW))
            return [replace(layer, turn=self.stage.turn_under(item, cover, yaw))]

        return lay
