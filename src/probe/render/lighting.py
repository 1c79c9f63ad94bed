"""From a lighting's name to the light itself."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from probe.assets.environments import environment_names, load_environment, sun_size
from probe.errors import UnknownName
from probe.render import illumination
from probe.render.illumination import Illumination
from probe.render.sunlight import illuminate
from probe.scene.lighting import AMBIENT, ROOM, Lighting


@lru_cache(maxsize=2)
def light_of(lighting: Lighting, assets: Path | None) -> Illumination:
    """The light that a lighting stands for; takes a second or two at first.

    Raises:
        UnknownName: No surroundings have this name.
        BadData: Their file can't be read.
    """
    if lighting == AMBIENT:
        return illumination.AMBIENT
    known = (ROOM.name, *environment_names(assets))
    if lighting.name not in known:
        raise UnknownName("lighting", lighting.name, [AMBIENT.name, *known])
    radiance = load_environment(lighting.name, assets)
    return illuminate(radiance, lighting.yaw, sun_size(lighting.name))
