"""Light as the renderer's cube maps, prepared once for each panorama. Knows no engine."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from probe.assets.cache import Cache, content_key
from probe.render.illumination import Illumination, Sun
from probe.render.prefilter import LIGHT_VERSION, backdrop_map, light_map
from probe.types import Array


@dataclass(frozen=True, eq=False)
class PackedLight:
    """Light as cube maps.

    Attributes:
        around: Prefiltered image-based light, a KTX1 file.
        backdrop: Its picture, a KTX1 file; None if the backdrop is plain.
        sun: What casts shadows, or None.
    """

    around: bytes
    backdrop: bytes | None
    sun: Sun | None


@dataclass(eq=False)
class LightPacker:
    """Prepares light; keeps what it prepared last, and prefiltered maps in a cache.

    Attributes:
        cache: Where prefiltered maps are kept by the panorama's content; None for nowhere.
    """

    cache: Cache | None = None
    _last: dict[str, PackedLight] = field(default_factory=dict[str, PackedLight], init=False)

    def pack(self, light: Illumination) -> PackedLight:
        """Cube maps of a light."""
        seen = b"" if light.backdrop is None else light.backdrop.tobytes()
        key = content_key(_key(light.radiance), seen, repr(light.sun))
        if key not in self._last:
            backdrop = None if light.backdrop is None else backdrop_map(light.backdrop)
            self._last = {key: PackedLight(self._prefiltered(light.radiance), backdrop, light.sun)}
        return self._last[key]

    def _prefiltered(self, radiance: Array) -> bytes:
        if self.cache is None:
            return light_map(radiance)
        stored = self.cache.load(_key(radiance))
        if stored is not None:
            return stored["ktx"].tobytes()
        made = light_map(radiance)
        self.cache.store(_key(radiance), {"ktx": np.frombuffer(made, np.uint8)})
        return made


def _key(radiance: Array) -> str:
    return content_key("light map", LIGHT_VERSION, str(radiance.shape), radiance.tobytes())
