"""Which light a scene stands in, by name. Data only; what the names hold lies in assets."""

from __future__ import annotations

from dataclasses import dataclass

from probe.assets.environments.day_room import COUNT, ROOM
from probe.scene.seeds import generator

__all__ = ["AMBIENT", "ROOM", "Lighting", "hdri", "lighting_of"]


@dataclass(frozen=True)
class Lighting:
    """A kind of light.

    Attributes:
        name: "ambient", "day_room_7", or the surroundings whose picture lights the table.
        yaw: How far the surroundings are turned about the vertical, radians, anticlockwise seen
            from above; 0 shows the middle of their panorama to the front camera.
    """

    name: str
    yaw: float = 0.0


AMBIENT = Lighting("ambient")
"""Even grey light from everywhere, no cast shadow."""


def lighting_of(name: str, seed: int) -> Lighting:
    """The light that a set-up's name of one means for a scene.

    Args:
        name: "day_room" is a day room by the scene's seed; another is the same for all scenes.
        seed: The scene's.
    """
    if name != ROOM:
        return Lighting(name)
    return Lighting(f"{ROOM}_{generator(seed, 'day room').integers(COUNT)}")


def hdri(name: str, yaw: float = 0.0) -> Lighting:
    """Light of surroundings: their colours, their brightest spot as a sun that casts shadows."""
    return Lighting(name, yaw)
