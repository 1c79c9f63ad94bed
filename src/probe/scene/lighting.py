"""Which light a scene stands in, by name. Data only; what the names hold lies in assets."""

from __future__ import annotations

import zlib
from dataclasses import dataclass

from probe.assets.environments.day_room import COUNT, ROOM

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


def lighting_of(name: str, table: str) -> Lighting:
    """The light that a set-up's name of one means for a scene.

    Args:
        name: "day_room" is the day room in which a table stands; another is the same for all.
        table: Id of the scene's table. Its seed wouldn't do: a private task's scene bears another
            one than it was made from.
    """
    if name != ROOM:
        return Lighting(name)
    return Lighting(f"{ROOM}_{zlib.crc32(f'room of {table}'.encode()) % COUNT}")


def hdri(name: str, yaw: float = 0.0) -> Lighting:
    """Light of surroundings: their colours, their brightest spot as a sun that casts shadows."""
    return Lighting(name, yaw)
