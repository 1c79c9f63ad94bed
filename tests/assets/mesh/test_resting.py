from __future__ import annotations

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from probe.assets.gltf.glb import load_glb
from probe.assets.mesh.resting import STEADY_DEG, rest_of

EDGE = st.floats(0.02, 0.3)
ANGLE = st.floats(-180, 180)


def _lying(vertices):
    rest = rest_of(vertices)
    assert rest is not None
    turned = vertices @ rest.turn.T
    return rest, turned - [0, 0, turned[:, 2].min()]


@given(edges=st.tuples(EDGE, EDGE, EDGE), angles=st.tuples(ANGLE, ANGLE, ANGLE))
@settings(max_examples=60)
def test_a_box_in_any_pose_comes_to_lie_on_a_face(edges, angles):
    turn = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    vertices = np.asarray(trimesh.creation.box(edges).vertices) @ turn.T
    rest, lying = _lying(vertices)
    assert np.linalg.det(rest.turn) == pytest.approx(1)
    assert (lying[:, 2] < 1e-6).sum() == 4
    # It stands as high as one of its edges is long.
    assert np.abs(np.array(edges) - lying[:, 2].max()).min() < 1e-6


@given(angles=st.tuples(ANGLE, ANGLE, ANGLE))
@settings(max_examples=30)
def test_what_lies_once_stays(angles):
    turn = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    cone = trimesh.creation.cone(0.04, 0.1, sections=24)
    lying = _lying(np.asarray(cone.vertices) @ turn.T)[1]
    again = rest_of(lying)
    assert again is not None and again.turned_deg < 1e-4


def test_a_standing_bottle_stays_and_a_tilted_one_is_set_upright():
    bottle = np.asarray(trimesh.creation.cylinder(0.03, 0.2, sections=48).vertices)
    upright = rest_of(bottle)
    assert upright is not None and upright.turned_deg == pytest.approx(0, abs=1e-6)
    # A cylinder topples where its centre passes its border: atan(radius / half height).
    assert upright.tilt_deg == pytest.approx(np.degrees(np.arctan(0.03 / 0.1)), abs=0.1)
    tilted = bottle @ Rotation.from_euler("x", 10, degrees=True).as_matrix().T
    set_up = rest_of(tilted)
    assert set_up is not None and set_up.turned_deg == pytest.approx(10, abs=1e-4)
    fallen = bottle @ Rotation.from_euler("x", 40, degrees=True).as_matrix().T
    lying = rest_of(fallen)
    assert lying is not None and lying.turned_deg == pytest.approx(50, abs=5)


@pytest.mark.parametrize("radius", [0.02, 0.05])
def test_a_ball_is_as_steady_as_the_dent_it_stands_on(radius):
    ball = rest_of(np.asarray(trimesh.creation.icosphere(5, radius).vertices))
    # A sphere's cap 0.2 mm deep is seen from its middle under sqrt(2 x depth / radius).
    assert ball is not None and np.radians(ball.tilt_deg) < np.sqrt(2 * 2e-4 / radius)


@pytest.mark.parametrize("seed", range(8))
def test_a_ball_of_few_facets_finds_a_face_to_lie_on_however_it_is_held(seed):
    generator = np.random.default_rng(seed)
    ball = np.asarray(trimesh.creation.icosphere(3, 0.036).vertices)
    ball = ball * generator.uniform(0.995, 1.005, (len(ball), 1))
    turn = Rotation.random(random_state=seed).as_matrix()
    rest = rest_of(ball @ turn.T)
    assert rest is not None and rest.tilt_deg >= STEADY_DEG
    lying = ball @ turn.T @ rest.turn.T
    # Its centre stands over what touches the table.
    low = lying[lying[:, 2] < lying[:, 2].min() + 2e-4]
    assert (np.abs(low[:, :2].mean(axis=0)) < 0.01).all()


def test_scanned_balls_stay_on_the_table_with_either_axis_up(assets):
    for name in ("ycb_054_softball", "ycb_015_peach", "ycb_017_orange", "ycb_056_tennis_ball"):
        vertices = load_glb(assets / "scans" / f"{name}.glb").vertices
        for axes in ((0, 1, 2), (0, 2, 1), (1, 2, 0)):
            rest = rest_of(vertices[:, axes])
            assert rest is not None and rest.tilt_deg >= STEADY_DEG, (name, axes)


def test_a_flat_sheet_has_no_rest():
    sheet = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0]], float)
    assert rest_of(sheet) is None
    assert rest_of(sheet[:2]) is None


def test_all_catalogued_scans_stand_as_people_judged(assets):
    from probe.assets.pools.scan_catalogue import scan_rows

    rows = [row for row in scan_rows() if row.confirmed][::12]
    for row in rows:
        rest = rest_of(load_glb(assets / "scans" / f"{row.id}.glb", row.up).vertices)
        assert rest is not None and rest.turned_deg < 6, row.id
