"""A World that keeps how it stood 55 times a simulated second, and moves as any other."""

from __future__ import annotations

from dataclasses import dataclass

from probe.assets.library import Library
from probe.scene.scene import PlacedObject, Scene
from probe.types import Array
from probe.world.world import TIME_STEP, World

SAMPLE_STEPS = 6
"""Time steps between two moments."""

SAMPLE_TIME = SAMPLE_STEPS * TIME_STEP
"""Simulated seconds between them."""


@dataclass(frozen=True, eq=False)
class TableMoment:
    """How a table stood.

    Attributes:
        time: Simulated seconds since the beginning.
        joints: Of the arm, radians, one a hinge.
        opening: Distance of the pads, metres.
        objects: Where each object was.
    """

    time: float
    joints: Array
    opening: float
    objects: tuple[PlacedObject, ...]


class WatchedWorld(World):
    """A World whose motion can be looked at afterwards.

    Attributes:
        moments: How it stood at the start, and then every SAMPLE_TIME.
    """

    def __init__(self, scene: Scene, library: Library) -> None:
        super().__init__(scene, library)
        self._steps = 0
        self.moments = [self._moment()]

    def step(self, count: int = 1) -> None:
        """Advance by so many time steps; see World.step()."""
        while count > 0:
            some = min(count, SAMPLE_STEPS - self._steps % SAMPLE_STEPS)
            super().step(some)
            self._steps += some
            count -= some
            if self._steps % SAMPLE_STEPS == 0:
                self.moments.append(self._moment())

    def _moment(self) -> TableMoment:
        return TableMoment(self.time, self.joints, self.opening, self.scene().objects)
