"""The robot as it is drawn: where the engine has it, and hardly larger than what collides."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest

from probe.scene.setup import UR5_TABLE, Setup
from probe.scene.setup_file import read_setup
from probe.stage.stage import FilmStage, robot_pieces
from probe.types import Array
from probe.world.robot.arms import ARMS
from probe.world.robot.frames import arm_frames
from probe.world.robot.gripper_shape import INNER_FINGER, PALM, inner_crank, outer_crank, pad
from probe.world.robot.solids import Cylinder, SolidBox

JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")
WHITE = np.full((2, 2, 3), 255, np.uint8)
ARM_OVER, HAND_OVER = 0.0025, 0.007
"""Metres by which a drawn robot may be larger than what collides."""


def solids(setup: Setup) -> Mapping[str, Sequence[Cylinder | SolidBox]]:
    arm, size = ARMS[setup.mount.arm], setup.gripper
    fingers = {
        "outer_crank": outer_crank(size),
        "inner_crank": inner_crank(size),
        "finger": (*INNER_FINGER, pad(size)),
    }
    return {
        "arm_base": arm.base,
        "palm": PALM,
        **{link.name: link.solids for link in arm.links},
        **{f"{side}_{name}": made for side in ("left", "right") for name, made in fingers.items()},
    }


def outside(points: Array, solid: Cylinder | SolidBox) -> Array:
    """How far points lie outside a solid, metres, shape (n,)."""
    if isinstance(solid, SolidBox):
        beyond = np.abs(points - solid.centre) - solid.half_size
        return np.linalg.norm(np.maximum(beyond, 0), axis=1)
    start, axis = np.array(solid.start), np.subtract(solid.end, solid.start)
    length = np.linalg.norm(axis)
    along = (points - start) @ axis / length
    away = np.linalg.norm(points - start - along[:, None] * axis / length, axis=1)
    past = np.maximum(np.abs(along - length / 2) - length / 2, 0)
    if solid.rounded:
        return np.maximum(np.hypot(past, away) - solid.radius, 0)
    return np.hypot(past, np.maximum(away - solid.radius, 0))


def beyond(points: Array, all_of_it: Iterable[Cylinder | SolidBox]) -> float:
    return float(np.min([outside(points, solid) for solid in all_of_it], axis=0).max())


@pytest.mark.parametrize("setup", [UR5_TABLE, JACO], ids=["ur5", "jaco"])
def test_what_is_drawn_is_hardly_larger_than_what_collides(setup: Setup) -> None:
    known = solids(setup)
    for piece in robot_pieces(setup):
        points = piece.mesh.vertices.astype(float)
        arm = piece.frame in arm_frames(setup.mount, setup.mount.parked) and piece.frame != "palm"
        assert beyond(points, known[piece.frame]) < (ARM_OVER if arm else HAND_OVER), piece.frame


def test_every_link_and_finger_is_drawn() -> None:
    for setup in (UR5_TABLE, JACO):
        drawn = {piece.frame for piece in robot_pieces(setup)}
        assert drawn == solids(setup).keys()


def test_the_pads_are_drawn_as_far_apart_as_they_are() -> None:
    stage = FilmStage.of(UR5_TABLE, WHITE)
    for opening in (0.0, 0.03, 0.09, UR5_TABLE.gripper.max_opening):
        placed = stage.placed(UR5_TABLE.mount.parked, opening)
        palm = arm_frames(UR5_TABLE.mount, UR5_TABLE.mount.parked)["palm"].inverse()
        faces: list[float] = []
        for piece, here in zip(stage.pieces, placed, strict=True):
            if piece.frame.endswith("_finger"):
                seen = palm.apply(here.pose.apply(piece.mesh.vertices.astype(float)))
                faces.append(float(np.abs(seen[:, 1]).min()))
        assert 2 * min(faces) == pytest.approx(opening, abs=3e-4)


def test_normals_point_out_and_are_units() -> None:
    for piece in FilmStage.of(UR5_TABLE, WHITE).pieces:
        mesh = piece.mesh
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)
        corners = mesh.vertices.astype(float)[mesh.faces]
        facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        agree = np.einsum("ij,ij->i", facing, mesh.normals[mesh.faces[:, 0]].astype(float)) > 0
        assert agree.mean() > 0.98, piece.frame


def test_what_stands_on_the_table_doesn_t_reach_into_it() -> None:
    """Nothing of the furniture lies above the table's top but pedestal, basket and walls."""
    stage = FilmStage.of(UR5_TABLE, WHITE)
    half = np.array(UR5_TABLE.table_size) / 2
    for piece in stage.pieces:
        points = piece.mesh.vertices
        if piece.frame == "world" and points[:, 2].max() < 0.001:
            over = np.abs(points[:, :2]).max(axis=0) <= half + 0.01
            assert points[:, 2].max() < 0 or not over.all()
