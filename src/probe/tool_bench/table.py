"""Settled tables to try the tools on, and which of their objects are tried."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE, Setup
from probe.station.simulated import SimulatedStation
from probe.types import Array, Frame
from probe.world.scenes import draw_scene
from probe.world.world import Snapshot, World

A_SCENE = 5
"""Targets at most in a scene."""


@dataclass(frozen=True, eq=False)
class TrialTable:
    """A settled table, to be restored before each trial.

    Attributes:
        restless: How many draws before it weren't at rest; see draw_scene().
    """

    scene: Scene
    restless: int
    world: World
    frame: Frame
    start: Snapshot
    targets: tuple[PlacedObject, ...]
    rng: np.random.Generator

    def mask(self, target: PlacedObject) -> Array:
        """True pixels of a target, bool, shape (h, w)."""
        assert self.frame.labels is not None
        return self.frame.labels == target.instance

    def share(self, target: PlacedObject) -> float:
        """Visible share of a target."""
        assert self.frame.shares is not None
        return self.frame.shares[target.instance]


def lay(
    seed: int, tool: str, things: Library, renderer: Renderer, setup: Setup = UR5_TABLE
) -> TrialTable:
    """A table of 15 objects, and targets drawn evenly from those that are seen.

    Raises:
        Unsatisfiable: Nothing settles from this seed.
    """
    drawn = draw_scene(seed, things, table_ids(things.assets), setup=setup)
    scene = drawn.scene
    load_scene(renderer, scene, things)
    world = World(scene, things)
    frame = SimulatedStation(world, renderer).observe(rgb=False)
    rng = generator(seed, "trials", tool)
    targets = _targets(scene, frame, rng)
    return TrialTable(scene, drawn.restless, world, frame, world.save(), targets, rng)


def _targets(scene: Scene, frame: Frame, rng: np.random.Generator) -> tuple[PlacedObject, ...]:
    assert frame.labels is not None and frame.shares is not None
    seen = [
        placed
        for placed in scene.objects
        if frame.shares.get(placed.instance, 0.0) >= SEEN_SHARE
        and np.count_nonzero(frame.labels == placed.instance) >= SEEN_PX
    ]
    return tuple(seen[int(index)] for index in rng.permutation(len(seen))[:A_SCENE])
