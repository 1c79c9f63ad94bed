"""From where, and in which light, a table is looked at. Data only."""

from __future__ import annotations

from dataclasses import dataclass, field

from probe.scene.lighting import AMBIENT, Lighting
from probe.scene.setup import UR5_TABLE, RendererName
from probe.types import Camera


@dataclass(frozen=True)
class Viewpoint:
    """How the station's camera sees.

    Attributes:
        camera: The fixed one, or one that has strayed.
        lighting: Of colour pictures; depth and labels need none.
        renderer: What draws them.
    """

    camera: Camera = field(default_factory=UR5_TABLE.camera)
    lighting: Lighting = AMBIENT
    renderer: RendererName = "filament"
