"""Which light a scene stands in, by name. Data only; what the names hold lies in assets."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Lighting:
    """A kind of light.

    Attributes:
        name: "ambient", "day_room", or the surroundings whose picture lights the table.
        yaw: How far the surroundings are turned about the vertical, radians, anticlockwise seen
            from above; 0 shows the middle of their panorama to the front camera.
    """

    name: str
    yaw: float = 0.0


AMBIENT = Lighting("ambient")
"""Even grey light from everywhere, no cast shadow."""


ROOM = Lighting("day_room")
"""Daylight from a window at the left, with soft shadows: what new scenes stand in."""


def hdri(name: str, yaw: float = 0.0) -> Lighting:
    """Light of surroundings: their colours, their brightest spot as a sun that casts shadows."""
    return Lighting(name, yaw)
