"""The Jaco on its table: parked, no camera sees it; at work, it reaches what lies there."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from probe.scene.setup_file import read_setup, sees_basket
from probe.station.arms import arm_of, hand_of
from probe.types import Array, Camera, Pose
from probe.world.robot.jaco_body import JACO

SETUP = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")
DIRECTIONS = np.array(list(itertools.product((-1.0, 0.0, 1.0), repeat=3)))


def outside(joints: Array) -> Array:
    """Points on the outside of the whole robot with its hand open, shape (n, 3), world."""
    arm, hand = arm_of(SETUP.mount), hand_of(SETUP)
    spheres = arm.spheres(joints)
    points = [spheres[:, None, :3] + spheres[:, None, 3:] * DIRECTIONS]
    world_from_hand = arm.forward(joints)
    for centre, half in hand.boxes(hand.max_opening):
        points.append(world_from_hand.apply(centre + half * DIRECTIONS)[None])
    for solid in JACO.base:
        ends = SETUP.mount.base.apply(np.array([solid.start, solid.end]))
        points.append(ends[:, None] + solid.radius * DIRECTIONS * [1.0, 1.0, 0.0])
    return np.concatenate([some.reshape(-1, 3) for some in points])


def shown(camera: Camera, points: Array) -> Array:
    pixels = camera.project(points)
    size = (camera.width_px, camera.height_px)
    return np.all((pixels >= 0) & (pixels < size), axis=1)


@pytest.mark.parametrize(
    "camera", [SETUP.camera("top"), SETUP.camera("front"), SETUP.basket_camera]
)
def test_the_parked_arm_is_in_no_picture(camera: Camera) -> None:
    assert not shown(camera, outside(np.array(SETUP.mount.parked))).any()


@pytest.mark.parametrize("camera", [SETUP.camera("top"), SETUP.camera("front")])
def test_an_arm_at_work_would_be(camera: Camera) -> None:
    arm = arm_of(SETUP.mount)
    at_work = arm.inverse(Pose((0.0, 0.0, 0.3), (0.0, 1.0, 0.0, 0.0)))[0]
    assert shown(camera, outside(at_work)).any()


def test_no_camera_sees_into_the_basket() -> None:
    assert not sees_basket(SETUP, "top") and not sees_basket(SETUP, "front")


@pytest.mark.parametrize(("tilt_deg", "share"), [(0.0, 1.0), (30.0, 0.9), (60.0, 0.75)])
def test_the_work_area_is_in_reach(tilt_deg: float, share: float) -> None:
    arm, reach = arm_of(SETUP.mount), hand_of(SETUP).pad_reach(0.06)
    axis = np.linspace(-SETUP.work_area / 2, SETUP.work_area / 2, 4)
    found: list[bool] = []
    for point in itertools.product(axis, axis, (0.03, 0.1, 0.2)):
        for heading in np.arange(6) * 60.0:
            turns = [[heading, 180.0 - tilt_deg, turn] for turn in (0.0, 45.0, 90.0, 135.0)]
            found.append(any(arm.inverse(tool_at(point, reach, angles)) for angles in turns))
    assert np.mean(found) >= share


def tool_at(point: tuple[float, ...], reach: float, angles_deg: list[float]) -> Pose:
    """The hand whose pads are at a point, by its Euler angles about z, y and z."""
    rotation = Rotation.from_euler("ZYZ", angles_deg, degrees=True)
    place = np.asarray(point) - reach * rotation.as_matrix()[:, 2]
    return Pose.of(place, rotation.as_quat(scalar_first=True))
