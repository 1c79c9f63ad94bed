"""Covers on their places, each laid over what it hides on a bare table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from probe.generation.object_selection import ObjectSelection
from probe.generation.stage import Poses, Stage
from probe.generation.twins import build_nest, right_above
from probe.world.model import Post


class CoveredPairs(Protocol):
    """What hides what in the twin scenes of one task."""

    def pairs_of(self, candidate: int) -> Sequence[tuple[int, int]]:
        """Instances on the stage of what is hidden and of what hides it; the candidate's first."""
        ...


@dataclass(frozen=True, eq=False)
class Nests:
    """Covers on their places, all but one with a thing beneath that stays the same.

    Attributes:
        cast: Who plays.
        stage: Made of the cast's specs.
        posts: Where each cover stands.
        place: Which of the covers hides the candidates.
        fixed: Poses of the other covers and of what is beneath them.
    """

    cast: ObjectSelection
    stage: Stage
    posts: Sequence[Post]
    place: int
    fixed: Poses

    @staticmethod
    def built(
        cast: ObjectSelection,
        stage: Stage,
        posts: Sequence[Post],
        place: int,
        rng: np.random.Generator,
    ) -> Nests:
        """Lay all covers but one.

        Raises:
            Rejected: One of them doesn't hide what is beneath it.
        """
        fixed: Poses = {}
        further = [number for number in range(len(posts)) if number != place]
        for secret, number in zip(cast.secrets, further, strict=True):
            lay = right_above(cast.covering[number], cast.covers[number])
            fixed |= build_nest(stage, secret, lay, posts[number], rng)
        return Nests(cast, stage, posts, place, fixed)

    def nest(self, target: int, rng: np.random.Generator) -> Poses:
        """All covers, with this candidate beneath its own; see twins.Nest."""
        lay = right_above(self.cast.covering[self.place], self.cast.covers[self.place])
        return {**build_nest(self.stage, target, lay, self.posts[self.place], rng), **self.fixed}

    def pairs_of(self, candidate: int) -> Sequence[tuple[int, int]]:
        """See CoveredPairs."""
        further = [n for number, n in enumerate(self.cast.covering) if number != self.place]
        mine = (candidate + 1, self.cast.covering[self.place])
        return (mine, *zip(self.cast.secrets, further, strict=True))
