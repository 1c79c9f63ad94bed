"""A piece of the stage: a mesh that moves with a part of the robot, or stands still."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.assets.procedural.form.sheet import Sheet
from probe.stage.solids import joined


@dataclass(frozen=True, eq=False)
class StagePiece:
    """A mesh of one material.

    Attributes:
        frame: Name of what it moves with, as in arm_frames() and finger_frames(); "world" stands
            still.
        mesh: In that frame, metres.
    """

    frame: str
    mesh: TexturedMesh


def piece(frame: str, surface: Material, *sheets: Sheet | Sequence[Sheet]) -> StagePiece:
    """Solids of one material that move together."""
    flat = [one for each in sheets for one in ([each] if isinstance(each, Sheet) else each)]
    return StagePiece(frame, joined(flat, surface))
