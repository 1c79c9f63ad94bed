"""What a held box tells of a camera, by pictures that are computed another way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from probe_bridge.config import BridgeCamera
from scipy.spatial.transform import Rotation

from held_boxes import BASE, BOX, SETUP, shown, told
from probe.robot_check.box import KnownBox
from probe.robot_check.calibration import Calibration, calibrated
from probe.robot_check.fitting import apart
from probe.robot_check.holding import Shown, sightings
from probe.robot_check.seeing import Depth
from probe.types import Pose

CAMERA = SETUP.camera("front")
POSE = CAMERA.world_from_camera


def turned(pose: Pose, axis: tuple[float, float, float], degrees: float) -> Pose:
    """A camera's pose turned about an axis of the world through the arm's base."""
    turn = np.eye(4)
    turn[:3, :3] = Rotation.from_rotvec(np.radians(degrees) * np.array(axis)).as_matrix()
    base = np.eye(4)
    base[:3, 3] = BASE.position
    return Pose.from_matrix(base @ turn @ np.linalg.inv(base) @ pose.matrix)


def off(pose: Pose, millimetres: float, degrees: float, rng: np.random.Generator) -> Pose:
    """A pose that is wrong by so much in some direction."""
    matrix = pose.matrix.copy()
    axis, way = rng.standard_normal(3), rng.standard_normal(3)
    axis *= np.radians(degrees) / np.linalg.norm(axis)
    matrix[:3, :3] = matrix[:3, :3] @ Rotation.from_rotvec(axis).as_matrix()
    matrix[:3, 3] += way * millimetres / 1000 / np.linalg.norm(way)
    return Pose.from_matrix(matrix)


def result(described: BridgeCamera, seed: int = 0, slip: float = 0.0) -> Calibration:
    return calibrated(sightings(shown(CAMERA, described, seed, slip)), BOX, BASE)


@pytest.mark.parametrize("seed", range(4))
def test_a_camera_that_is_a_little_off_is_mended(seed: int):
    wrong = off(POSE, 2.0, 0.5, np.random.default_rng(seed))
    found = result(told(CAMERA, wrong), seed, slip=0.001)
    assert found.fault == "" and found.places == 10 and found.mendable
    moved, turn = apart(found.corrected, POSE)
    assert moved < 0.001
    assert np.degrees(turn) < 0.08
    assert found.before > 0.002 and found.after is not None and found.after < found.before / 3
    assert found.error[0] == pytest.approx(0.002, abs=0.001)
    assert np.degrees(found.error[1]) == pytest.approx(0.5, abs=0.08)


def test_a_camera_that_has_been_pushed_is_named_and_mended():
    found = result(told(CAMERA, off(POSE, 5.0, 5.0, np.random.default_rng(1))))
    assert found.fault == "camera moved" and found.mendable
    assert apart(found.corrected, POSE)[0] < 0.002


@pytest.mark.parametrize("share", [0.8, 0.92, 0.97, 1.03, 1.15])
def test_wrong_intrinsics(share: float):
    camera = told(CAMERA, off(POSE, 2.0, 0.5, np.random.default_rng(2)))
    found = result(replace(camera, fx=share * camera.fx, fy=share * camera.fy))
    assert found.fault == "wrong intrinsics"
    assert not found.mendable


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda depth: depth[:, ::-1], "left and right"),
        (lambda depth: depth[::-1], "top and bottom"),
        (np.transpose, "rows and columns"),
    ],
)
def test_mirrored_pictures(change, says: str):
    described = told(CAMERA, off(POSE, 2.0, 0.5, np.random.default_rng(3)))
    mirrored = [
        Shown(
            Depth(described, change(each.held.depth)),
            Depth(described, change(each.bare.depth)),
            each.world_from_box,
        )
        for each in shown(CAMERA, described, 3)
    ]
    found = calibrated(sightings(mirrored), BOX, BASE)
    assert found.fault == "mirrored picture" and says in found.text


@pytest.mark.parametrize("degrees", [90, -90, 180])
def test_a_base_that_is_turned(degrees: int):
    found = result(told(CAMERA, turned(POSE, (0.0, 0.0, 1.0), degrees)))
    assert found.fault == "base rotated"
    assert f"{abs(degrees)} degrees about the vertical" in found.text


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, 0.0, 1.0)])
def test_exchanged_axes_of_a_camera(axis: tuple[float, float, float]):
    half = Rotation.from_rotvec(np.pi * np.array(axis)).as_quat(scalar_first=True)
    found = result(told(CAMERA, POSE @ Pose.of(np.zeros(3), half)))
    assert found.fault == "swapped axes" and "180 degrees" in found.text


def test_joints_in_another_order_leave_no_rigid_picture():
    rng = np.random.default_rng(4)
    seen = sightings(shown(CAMERA, told(CAMERA, POSE), 4))
    order = rng.permutation(len(seen))
    mixed = [
        replace(each, world_from_box=seen[k].world_from_box)
        for each, k in zip(seen, order, strict=True)
    ]
    assert calibrated(mixed, BOX, BASE).fault == "swapped axes"


def test_depth_in_another_unit():
    described = told(CAMERA, POSE)
    feet = [
        Shown(
            Depth(described, 3.28 * each.held.depth),
            Depth(described, 3.28 * each.bare.depth),
            each.world_from_box,
        )
        for each in shown(CAMERA, described, 5)
    ]
    assert calibrated(sightings(feet), BOX, BASE).fault == "wrong depth unit"


def test_nothing_is_seen_where_nothing_changes():
    described = told(CAMERA, POSE)
    bare = [replace(each, held=each.bare) for each in shown(CAMERA, described, 6)]
    assert sightings(bare) == []


def test_distances_from_a_box():
    box = KnownBox((0.2, 0.4, 0.6))
    points = np.array([[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0], [0.13, 0.24, 0.3], [0, 0.15, 0]])
    assert box.distances(points) == pytest.approx([-0.1, 0, 0.1, 0.05, -0.05])


def test_the_middle_of_what_shows_is_on_the_sides_that_show():
    box = KnownBox((0.2, 0.2, 0.2))
    far = box.seen_middle(Pose((1.0, 0.0, 0.0)), np.array([1.0, 0.0, 50.0]))
    assert far == pytest.approx([1.0, 0.0, 0.1], abs=1e-6)
    slanting = box.seen_middle(Pose(), np.array([0.0, 100.0, 100.0]))
    assert slanting == pytest.approx([0.0, 0.05, 0.05], abs=1e-3)
