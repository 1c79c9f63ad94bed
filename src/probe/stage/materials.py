"""What the stage is made of."""

from __future__ import annotations

import numpy as np

from probe.assets.mesh.mesh import Material
from probe.types import Array


def plain(colour: tuple[float, float, float] | Array, roughness: float, metallic: float = 0.0):
    """A material of one colour, sRGB from 0 to 1."""
    texture = np.round(np.asarray(colour, dtype=float) * 255).astype(np.uint8).reshape(1, 1, 3)
    return Material(texture, roughness, metallic)
