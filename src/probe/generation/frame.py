"""Turns poses on a stage into a Scene whose numbers tell nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.object_selection import ObjectSelection
from probe.generation.stage import Poses
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import Setup


@dataclass(frozen=True, eq=False)
class SceneFrame:
    """Turns poses on a stage into a Scene: its numbers, its seed and its table.

    Attributes:
        seed, table, setup: As in Scene.
        ids: Object id of each instance on the stage.
        number_of: Scene's number of each instance on the stage; candidates share one.
    """

    seed: int
    table: str
    ids: dict[int, str]
    number_of: dict[int, int]
    setup: Setup

    @classmethod
    def of(
        cls,
        specs: Sequence[ObjectSpec],
        seed: int,
        table: str,
        rng: np.random.Generator,
        setup: Setup,
    ) -> SceneFrame:
        """A frame of things that stand on a stage in this order."""
        ids = {number: spec.id for number, spec in enumerate(specs, start=1)}
        return cls(seed, table, ids, dict(enumerate(_numbers(len(specs), rng), start=1)), setup)

    def scene(self, poses: Poses) -> Scene:
        """The scene of these poses."""
        placed = [
            PlacedObject(self.number_of[number], self.ids[number], pose)
            for number, pose in poses.items()
        ]
        objects = tuple(sorted(placed, key=lambda o: o.instance))
        return Scene(self.seed, self.table, objects, self.setup)


def _numbers(count: int, rng: np.random.Generator) -> list[int]:
    """Instance numbers of a scene in random order, so that they tell nothing."""
    return [int(number) + 1 for number in rng.permutation(count)]


def frame_of(
    cast: ObjectSelection, seed: int, table: str, rng: np.random.Generator, setup: Setup
) -> SceneFrame:
    """A frame that gives all candidates the same number, so that twins differ in nothing else."""
    rest = (*cast.secrets, *cast.covering, *cast.crowd, *cast.toppings)
    drawn = _numbers(len(rest) + 1, rng)
    number_of = dict.fromkeys(range(1, len(cast.candidates) + 1), drawn[0])
    number_of |= dict(zip(rest, drawn[1:], strict=True))
    ids = {number: spec.id for number, spec in enumerate(cast.specs, start=1)}
    return SceneFrame(seed, table, ids, number_of, setup)
