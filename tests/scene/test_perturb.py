"""Seeded changes stay within their ranges and repeat."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.scene.perturb import (
    PoseRange,
    ViewRange,
    any_lighting,
    jittered,
    moved_view,
    other_table,
)
from probe.scene.scene import PlacedObject, Scene
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE
from probe.types import Pose

LYING = Pose.of(np.array([0.1, -0.1, 0.02]), np.array([0.5, 0.5, -0.5, 0.5]))
SCENE = Scene(1, "oak_planks", (PlacedObject(1, "mug", LYING), PlacedObject(2, "pen", Pose())))


def angle(first: Pose, second: Pose) -> float:
    return 2 * math.acos(min(1.0, abs(float(np.dot(first.wxyz, second.wxyz)))))


@given(st.integers(0, 10**6))
def test_a_view_stays_within_its_range(seed):
    for camera in (UR5_TABLE.camera(), UR5_TABLE.camera("front")):
        within = ViewRange()
        moved = moved_view(camera, generator(seed, "view"), within)
        shift = np.abs(
            np.subtract(moved.world_from_camera.position, camera.world_from_camera.position)
        )
        assert (shift <= [within.shift, within.shift, within.height]).all()
        assert angle(moved.world_from_camera, camera.world_from_camera) <= within.tilt + 1e-6
        assert moved == moved_view(camera, generator(seed, "view"), within)


@given(st.integers(0, 10**6))
def test_objects_move_a_little_and_keep_their_side_down(seed):
    within = PoseRange()
    moved = jittered(SCENE, generator(seed, "jitter"), within)
    for before, after in zip(SCENE.objects, moved.objects, strict=True):
        shift = np.abs(np.subtract(after.pose.position, before.pose.position))
        assert (shift <= [within.shift, within.shift, 1e-12]).all()
        assert angle(after.pose, before.pose) <= within.turn + 1e-6
        # What pointed up still points up.
        up = before.pose.rotation.T @ [0, 0, 1]
        assert after.pose.rotation @ up == pytest.approx([0, 0, 1], abs=1e-9)


def test_another_table_and_any_light():
    tables = ("oak_planks", "slate", "cork")
    found = {other_table(SCENE, tables, generator(seed, "table")).table for seed in range(40)}
    assert found == {"slate", "cork"}
    with pytest.raises(ValueError, match="oak_planks"):
        other_table(SCENE, ("oak_planks",), generator(0))
    lights = {any_lighting(("a", "b"), generator(seed)).name for seed in range(20)}
    assert lights == {"a", "b"}
    with pytest.raises(ValueError, match="no surroundings"):
        any_lighting((), generator(0))


def test_the_front_camera_sees_the_whole_work_area():
    half = UR5_TABLE.work_area / 2
    corners = np.array([[x, y, z] for x in (-half, half) for y in (-half, half) for z in (0, 0.2)])
    uv = UR5_TABLE.camera("front").project(corners)
    assert (uv > 0).all() and (uv < 1024).all()
    # Right is +x, as from above; what is far off is higher in the picture.
    assert uv[4:, 0].min() > 512 > uv[:4, 0].max()
