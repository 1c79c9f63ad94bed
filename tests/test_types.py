"""Poses and cameras, by property."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from probe.types import Camera, Pose, looking_at, quaternion_of

lengths = st.floats(-3, 3)
points = st.tuples(lengths, lengths, lengths)
rotations = st.tuples(lengths, lengths, lengths).map(Rotation.from_rotvec)


def pose_of(position, rotation: Rotation) -> Pose:
    x, y, z, w = rotation.as_quat()
    return Pose.of(np.array(position), np.array([w, x, y, z]))


@given(points, rotations)
def test_rotation_agrees_with_scipy(position, rotation):
    assert np.allclose(pose_of(position, rotation).rotation, rotation.as_matrix(), atol=1e-9)


@given(rotations)
def test_quaternion_of_inverts_a_rotation_matrix(rotation):
    x, y, z, w = rotation.as_quat()
    expected = np.array([w, x, y, z]) * (1 if w >= 0 else -1)
    found = quaternion_of(rotation.as_matrix())
    assert min(np.abs(found - expected).max(), np.abs(found + expected).max()) < 1e-6


@given(points, rotations, points)
def test_inverse_undoes(position, rotation, point):
    pose = pose_of(position, rotation)
    there = pose.apply(np.array([point]))
    assert np.allclose(pose.inverse().apply(there), [point], atol=1e-9)


@given(points, rotations, points, rotations, points)
def test_product_applies_the_right_one_first(p1, r1, p2, r2, point):
    first, second = pose_of(p1, r1), pose_of(p2, r2)
    expected = second.apply(first.apply(np.array([point])))
    assert np.allclose((second @ first).apply(np.array([point])), expected, atol=1e-7)


@given(points, rotations, st.floats(0, 640), st.floats(0, 480), st.floats(0.1, 5))
def test_lift_and_project_round_trip(position, rotation, u, v, depth):
    camera = Camera(pose_of(position, rotation), 640, 480, fov_y_deg=40)
    point = camera.lift(np.array([[u, v]]), np.array([depth]))
    assert np.allclose(camera.project(point), [[u, v]], atol=1e-6)


def test_points_behind_the_camera_project_to_nan():
    camera = Camera(Pose(), 640, 480, fov_y_deg=40)
    assert np.isnan(camera.project(np.array([[0.0, 0.0, -1.0]]))).all()


def test_principal_point_lifts_along_the_axis():
    camera = Camera(Pose(), 640, 480, fov_y_deg=40)
    assert np.allclose(camera.lift(np.array([[320, 240]]), np.array([2.0])), [[0, 0, 2]])


@given(points.filter(lambda p: np.hypot(p[0], p[1]) > 0.1))
def test_a_camera_sees_what_it_looks_at_in_the_middle_and_upright(eye):
    camera = Camera(looking_at(np.array(eye), np.zeros(3)), 640, 480, fov_y_deg=40)
    middle, above = camera.project(np.array([[0, 0, 0], [0, 0, 0.001]]))
    assert np.allclose(middle, [320, 240], atol=1e-6)
    assert above[1] < 240


def test_looking_straight_down_is_refused():
    with pytest.raises(ValueError, match="vertical"):
        looking_at(np.array([0.0, 0.0, 1.0]), np.zeros(3))
