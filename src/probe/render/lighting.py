"""From a lighting's name to the light itself."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from probe.assets.environments import environment_names, load_environment
from probe.assets.environments.day_room import COUNT, ROOM, day_room, day_room_number
from probe.assets.environments.lens import taking
from probe.assets.environments.painter import sketch_room
from probe.errors import UnknownName
from probe.render import illumination
from probe.render.illumination import Illumination
from probe.render.sunlight import illuminate
from probe.scene.lighting import AMBIENT, Lighting


@lru_cache(maxsize=2)
def light_of(lighting: Lighting, assets: Path | None) -> Illumination:
    """The light that a lighting stands for; takes a second or two at first.

    Raises:
        UnknownName: No surroundings have this name.
        BadData: Their file can't be read.
    """
    require_light(lighting.name, assets)
    if lighting == AMBIENT:
        return illumination.AMBIENT
    number = day_room_number(lighting.name)
    if number is not None:
        return illuminate(sketch_room(day_room(number)), lighting.yaw, taking(number))
    return illuminate(load_environment(lighting.name, assets), lighting.yaw)


def require_light(name: str, assets: Path | None) -> None:
    """See that there is a light of this name, or a family of them.

    Raises:
        UnknownName: There is none.
    """
    names = environment_names(assets)
    if name not in (AMBIENT.name, ROOM, *names) and day_room_number(name) is None:
        known = [AMBIENT.name, ROOM, f"{ROOM}_0 to {ROOM}_{COUNT - 1}", *names]
        raise UnknownName("lighting", name, known)
