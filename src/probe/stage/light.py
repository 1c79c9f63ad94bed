"""The light of the stage: a bright room, and a lamp over the camera's shoulder."""

from __future__ import annotations

import numpy as np

from probe.render.illumination import Illumination, Sun, directions
from probe.types import Vector3

_HEIGHT_PX = 32
_CEILING, _HORIZON, _FLOOR = 0.80, 0.35, 0.30
"""Radiance from above, from the sides and from below."""

_LAMP: Vector3 = (0.339, -0.533, 0.775)
_LAMP_IRRADIANCE: Vector3 = (0.85, 0.83, 0.78)


def stage_light() -> Illumination:
    """Light in which things cast shadows and round things look round."""
    up = directions(_HEIGHT_PX)[..., 2]
    grey = np.where(
        up > 0, _HORIZON + (_CEILING - _HORIZON) * up, _HORIZON + (_HORIZON - _FLOOR) * up
    )
    radiance = np.repeat(grey[..., None], 3, axis=-1).astype(np.float16)
    return Illumination(radiance, Sun(_LAMP, _LAMP_IRRADIANCE))
