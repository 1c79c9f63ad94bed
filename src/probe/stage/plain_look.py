"""How a robot without a look of its own is drawn: as the solids that collide."""

from __future__ import annotations

from collections.abc import Sequence

from probe.assets.procedural.form.sheet import Sheet
from probe.scene.setup import GripperSize
from probe.stage.materials import plain
from probe.stage.part import StagePiece, piece
from probe.stage.solids import block, capsule, drum
from probe.world.robot.arm_body import ArmBody
from probe.world.robot.gripper_shape import INNER_FINGER, PALM, inner_crank, outer_crank, pad
from probe.world.robot.solids import Cylinder, SolidBox


def arm_solids(arm: ArmBody) -> list[StagePiece]:
    """An arm from what its links collide with."""
    parts = [("arm_base", arm.base), *((link.name, link.solids) for link in arm.links)]
    return [each for name, solids in parts for each in _pieces(name, solids)]


def gripper_solids(size: GripperSize) -> list[StagePiece]:
    """A hand from what it collides with."""
    parts = {
        "outer_crank": outer_crank(size),
        "inner_crank": inner_crank(size),
        "finger": (*INNER_FINGER, pad(size)),
    }
    fingers = [(f"{side}_{name}", parts[name]) for side in ("left", "right") for name in parts]
    return [each for name, solids in (("palm", PALM), *fingers) for each in _pieces(name, solids)]


def _pieces(frame: str, solids: Sequence[Cylinder | SolidBox]) -> list[StagePiece]:
    return [piece(frame, plain(solid.colour, 0.5), _sheets(solid)) for solid in solids]


def _sheets(solid: Cylinder | SolidBox) -> Sheet | list[Sheet]:
    if isinstance(solid, SolidBox):
        return block(solid.centre, solid.half_size, 0.001)
    if solid.rounded:
        return capsule(solid.start, solid.end, solid.radius)
    return drum(solid.start, solid.end, solid.radius, 0.001)
