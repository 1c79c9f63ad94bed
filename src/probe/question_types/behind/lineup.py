"""Where an occluder and what it hides stand in a row, as seen from the camera."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.generation.covers import Cover, Footprint
from probe.generation.stage import Layer
from probe.types import Array, Camera
from probe.world.model import Post

_ACROSS, _ALONG = 0.08, (0.03, 0.11)
"""Where the hidden thing stands, metres from the middle: to either side, and away."""

_GAP = (0.005, 0.02)
"""Metres between the two."""

_TURN = math.radians(12)
_MARGIN = 0.015
_CORRIDOR = 0.06
"""Radius in metres of the places before and behind the two that are kept free."""


@dataclass(frozen=True, eq=False)
class Lineup:
    """Camera, occluder and hidden thing in a row; metres.

    Attributes:
        place: Middle (x, y) of what is hidden.
        away: Direction from the camera to there, along the table, a unit vector.
        occluder: What stands in front.
        room: Most that one of the candidates needs.
    """

    place: Array
    away: Array
    occluder: Cover
    room: float

    @staticmethod
    def drawn(
        camera: Camera, occluder: Cover, items: Sequence[Footprint], rng: np.random.Generator
    ) -> Lineup:
        """Draw a row near the middle of the table.

        Args:
            camera: Sees it.
            occluder: Stands in front.
            items: The candidates.
            rng: Draws the place.
        """
        place: Array = np.array([rng.uniform(-_ACROSS, _ACROSS), rng.uniform(*_ALONG)])
        ray = place - np.array(camera.world_from_camera.position[:2])
        room = max(item.width for item in items)
        return Lineup(place, ray / np.linalg.norm(ray), occluder, room)

    @property
    def middle(self) -> Post:
        """Where the hidden thing stands."""
        return Post(float(self.place[0]), float(self.place[1]), self.room / 2)

    @property
    def kept_free(self) -> tuple[Post, ...]:
        """Where nothing else may fall: around the two, before them, and in their shadow."""
        depth = self.occluder.extent[1]
        length = self.room + _GAP[1] + depth
        radius = max(length, self.occluder.extent[0]) / 2 + _MARGIN
        around = self.place + self.away * (self.room - length) / 2
        before = around - self.away * (radius + _CORRIDOR)
        beyond = around + self.away * (radius + _CORRIDOR)
        places = (around, radius), (before, _CORRIDOR), (beyond, _CORRIDOR)
        return tuple(Post(float(x), float(y), reach) for (x, y), reach in places)

    def layer(self, instance: int, width: float, rng: np.random.Generator) -> Layer:
        """Draw how the occluder stands before something of this width, its wide side across."""
        apart = width / 2 + rng.uniform(*_GAP) + self.occluder.extent[1] / 2
        across = math.atan2(self.away[1], self.away[0]) - math.pi / 2
        turn = across + rng.uniform(-_TURN, _TURN) + math.pi * rng.integers(2)
        return Layer(instance, self.occluder, -apart * self.away, float(turn))
