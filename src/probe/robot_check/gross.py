"""What is badly wrong with a camera or with an arm's base, told from how its places are distorted.

If no pose near the told one explains what was seen, an affine map from places by camera to places
by joints says why: a rigid one would do if only the pose were wrong.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from probe.robot_check.box import KnownBox
from probe.robot_check.fitting import Fitted, fitted
from probe.robot_check.seeing import SeenBox, told_pose
from probe.types import Array, Pose

_FITS = 0.004
"""Metres of median distance from the box up to which a pose explains what was seen."""

_RIGID = 0.025
"""Metres of median error of the affine map up to which it says something."""

_SCALE = 0.15
"""By which share a scale must be off to be told: places are known from the side that shows."""

_SMALL = np.radians(12.0)
"""Turn that counts as that of a camera that was pushed, radians."""

_CLOSE = np.radians(15.0)
"""How close to whole quarters a turn must be to be one, radians."""

_STAYS = 0.08
"""Metres by which a camera of which only the axes are wrong may seem to stand elsewhere."""


@dataclass(frozen=True)
class Gross:
    """What is badly wrong.

    Attributes:
        fault: What it is, or "".
        text: How it shows.
        remedy: How to mend it.
        fit: The camera that explains what was seen; None if none does.
    """

    fault: str
    text: str
    remedy: str
    fit: Fitted | None = None


def judged(sightings: Sequence[SeenBox], box: KnownBox, base: Pose) -> Gross:
    """Name what is wrong.

    Args:
        sightings: At least six, not all in a plane.
        box: What was held.
        base: world_from_base of the arm.
    """
    told = told_pose(sightings[0].camera)
    near = fitted(sightings, box, told, focal=True)
    if near.residual < _FITS:
        return _turned(near, told, base)
    seen = np.array([np.median(each.points, axis=0) for each in sightings])
    eye = np.asarray(told.position)
    there = np.array([box.seen_middle(each.world_from_box, eye) for each in sightings])
    linear, off = _affine(seen, there)
    if off > _RIGID:
        return _no_camera()
    if np.linalg.det(linear) < 0:
        return _mirrored(told.rotation.T @ linear)
    turn, sizes = _polar(linear)
    if (np.abs(sizes - 1) > _SCALE).all():
        return _scaled(float(np.median(sizes)))
    far = fitted(sightings, box, _pose(turn, there, seen), focal=True)
    return _no_camera() if far.residual > _FITS else _turned(far, told, base)


def _no_camera() -> Gross:
    """Name what no pose of a camera explains."""
    text = "No camera would see the box where the joints put it, wherever it stood."
    remedy = "Compare the joints' order and directions with the robot's file and the set-up."
    return Gross("swapped axes", text, remedy)


def _affine(seen: Array, there: Array) -> tuple[Array, float]:
    """Linear part, shape (3, 3), of the best map from seen to there; its median error, metres."""
    design = np.column_stack([seen, np.ones(len(seen))])
    solved = np.linalg.lstsq(design, there, rcond=None)[0]
    off = np.linalg.norm(design @ solved - there, axis=1)
    return solved[:3].T, float(np.median(off))


def _polar(linear: Array) -> tuple[Array, Array]:
    """The rotation nearest to a matrix, shape (3, 3), and how much it stretches, shape (3,)."""
    u, sizes, v = np.linalg.svd(linear)
    return u @ v, sizes


def _pose(turn: Array, there: Array, seen: Array) -> Pose:
    """A camera with this rotation that sees the middle of all places where it is."""
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    matrix[:3, 3] = there.mean(axis=0) - turn @ seen.mean(axis=0)
    return Pose.from_matrix(matrix)


def _mirrored(local: Array) -> Gross:
    """Name a reflection, given in the told camera's frame."""
    kinds = {
        "left and right are exchanged": np.diag([-1.0, 1.0, 1.0]),
        "top and bottom are exchanged": np.diag([1.0, -1.0, 1.0]),
        "rows and columns are exchanged": np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0, 0, 1.0]]),
    }
    how = min(kinds, key=lambda kind: float(np.linalg.norm(local - kinds[kind])))
    remedy = "Switch the mirroring off in the camera's driver, for colours and for depth."
    return Gross("mirrored picture", f"The picture is mirrored: {how}.", remedy)


def _scaled(scale: float) -> Gross:
    """Name a scale that isn't 1."""
    fault = "depth in millimetres" if 5e-4 < scale < 2e-3 else "wrong depth unit"
    text = f"All lengths are {scale:.3g} times what the camera says."
    return Gross(fault, text, "Correct the driver's depth_unit.")


def _turned(fit: Fitted, told: Pose, base: Pose) -> Gross:
    """Name a turn that is too large for a camera that was only pushed."""
    start = fit.world_from_camera
    world = Rotation.from_matrix(start.rotation @ told.rotation.T)
    if world.magnitude() < _SMALL:
        return Gross("", "", "", fit)
    degrees = np.degrees(world.magnitude())
    rotvec: Array = world.as_rotvec()
    stayed = float(np.linalg.norm(np.subtract(start.position, told.position))) < _STAYS
    upright = abs(float(rotvec[2])) > np.cos(_CLOSE) * world.magnitude()
    quarter = round(float(np.degrees(rotvec[2])) / 90) * 90
    if upright and not stayed and abs(degrees - abs(quarter)) < np.degrees(_CLOSE):
        x, y, _ = base.position
        return Gross(
            "base rotated",
            f"By the camera, the arm's base at ({x:.2f}, {y:.2f}) is turned by {-quarter} degrees"
            " about the vertical against what the set-up says.",
            "Correct the turn of the base in the set-up and of the mount in the robot's file,"
            " or the cameras' poses, if they were measured from other axes.",
        )
    local = told.rotation.T @ start.rotation
    if stayed and float(np.abs(local).max(axis=1).min()) > np.cos(_CLOSE):
        text = f"The camera's axes are exchanged: it is turned by {degrees:.0f} degrees in place."
        remedy = "Its pose has to be written with x right, y down, z forward, and wxyz."
        return Gross("swapped axes", text, remedy)
    text = f"The camera is turned by {degrees:.0f} degrees against what its bridge says."
    return Gross("camera moved", text, "Measure its pose again.", fit)
