"""In what an episode differs from its task as it was frozen, and which tool is held ideal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from probe.perception.dials import Dials
from probe.scene.perturb import CameraName

LightKind = Literal["own", "hdri"]
TableKind = Literal["own", "other"]
RendererKind = Literal["own", "filament", "blender"]
Ideal = Literal["none", "grasp", "perception"]

NO_DIALS = Dials()


@dataclass(frozen=True)
class Conditions:
    """What all episodes of a run have in common, in names; the task's seed draws the details.

    Attributes:
        lighting: The task's own light, or surroundings drawn for each task.
        camera: How the camera strays; shifted (along the table), raised (up or down),
            tilted, or moved (all three).
        table: The task's own table top, or another one drawn for each task.
        pose_jitter: How far each object is moved before the start, metres at most.
        dials: Error rates of the ideal detector, for each detected object.
        ideal: Which tool makes no errors: grasps, or perception; to split errors by their cause.
        renderer: What draws the pictures: as the task was frozen, or another; blender needs the
            extra of that name, and more time.
    """

    lighting: LightKind = "own"
    camera: CameraName = "fixed"
    table: TableKind = "own"
    pose_jitter: float = 0.0
    dials: Dials = NO_DIALS
    ideal: Ideal = "none"
    renderer: RendererKind = "own"

    @property
    def label(self) -> str:
        """What differs, in a few words; empty if nothing does."""
        parts = [
            "" if self.lighting == "own" else f"lighting {self.lighting}",
            "" if self.camera == "fixed" else f"camera {self.camera}",
            "" if self.table == "own" else f"table {self.table}",
            f"jitter {1000 * self.pose_jitter:g} mm" if self.pose_jitter else "",
            _dials_label(self.dials),
            "" if self.ideal == "none" else f"ideal {self.ideal}",
            "" if self.renderer == "own" else f"renderer {self.renderer}",
        ]
        return ", ".join(part for part in parts if part)


AS_FROZEN = Conditions()


def _dials_label(dials: Dials) -> str:
    rates = {name: rate for name, rate in vars(dials).items() if rate}
    return " ".join(f"{name} {rate:g}" for name, rate in rates.items())
