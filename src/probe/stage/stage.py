"""A set-up's stage: meshes for a renderer, and where each is at a moment."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.mesh.mesh import TexturedMesh
from probe.scene.scene import PlacedObject
from probe.scene.setup import Setup
from probe.stage.furniture import furniture, room
from probe.stage.gripper_look import gripper_pieces
from probe.stage.part import StagePiece
from probe.stage.plain_look import arm_solids, gripper_solids
from probe.stage.ur5_look import ur5_pieces
from probe.types import Array, Pose
from probe.world.robot.arms import ARMS
from probe.world.robot.frames import arm_frames, finger_frames
from probe.world.robot.gripper import joint_for

_FIRST = 1_000_000
"""Numbers of the pieces begin here, above any object's."""


def robot_pieces(setup: Setup) -> list[StagePiece]:
    """A set-up's arm and hand; one without a look of its own as what collides."""
    if setup.mount.arm == "ur5":
        return [*ur5_pieces(), *gripper_pieces(setup.gripper)]
    return [*arm_solids(ARMS[setup.mount.arm]), *gripper_solids(setup.gripper)]


def robot_frames(setup: Setup, joints: Sequence[float] | Array, opening: float) -> dict[str, Pose]:
    """world_from_part of every part of a set-up's arm and hand, by name.

    Args:
        setup: Which arm and hand, and where.
        joints: Of the arm, radians, one a hinge.
        opening: Distance of the pads, metres.
    """
    frames, size = arm_frames(setup.mount, joints), setup.gripper
    finger = joint_for(float(np.clip(opening, 0.0, size.max_opening)), size)
    palm = frames["palm"]
    return frames | {name: palm @ pose for name, pose in finger_frames(finger, size).items()}


@dataclass(frozen=True, eq=False)
class FilmStage:
    """What a film shows beside the objects."""

    setup: Setup
    pieces: tuple[StagePiece, ...]

    @staticmethod
    def of(setup: Setup, table_texture: Array) -> FilmStage:
        """The stage of a set-up.

        Args:
            setup: Its arm, hand, table and basket.
            table_texture: Of the table's top, uint8, shape (h, w, 3); its edge has its mean colour.
        """
        colour = table_texture.reshape(-1, 3).mean(axis=0) / 255
        pieces = (*robot_pieces(setup), *furniture(setup, colour), *room(setup.table_size))
        return FilmStage(setup, pieces)

    @property
    def meshes(self) -> Mapping[str, TexturedMesh]:
        """The pieces' meshes by the ids that placed() uses."""
        return {_id(number): each.mesh for number, each in enumerate(self.pieces)}

    def placed(self, joints: Sequence[float] | Array, opening: float) -> tuple[PlacedObject, ...]:
        """Where each piece is.

        Args:
            joints: Of the arm, radians, one a hinge.
            opening: Distance of the pads, metres.
        """
        frames = {"world": Pose(), **robot_frames(self.setup, joints, opening)}
        return tuple(
            PlacedObject(_FIRST + number, _id(number), frames[each.frame])
            for number, each in enumerate(self.pieces)
        )


def _id(number: int) -> str:
    return f"stage/{number}"
