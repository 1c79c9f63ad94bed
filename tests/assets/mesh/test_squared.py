"""Boxes of things that lie askew."""

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from probe.assets.mesh.squared import squaring_turn


@given(angle=st.floats(-180, 180), width=st.floats(0.02, 0.1), length=st.floats(0.12, 0.4))
def test_a_box_askew_has_its_own_sides_again(angle, width, length):
    turn = Rotation.from_euler("z", angle, degrees=True).as_matrix()
    askew = np.asarray(trimesh.creation.box((length, width, 0.03)).vertices) @ turn.T
    found = squaring_turn(askew)
    assert np.linalg.det(found) == pytest.approx(1) and found[2, 2] == 1
    size = sorted(np.ptp(askew @ found.T, axis=0))
    # What is within two per cent of the smallest box stays as it is.
    assert size[1] * size[2] <= 1.021 * max(width * length, 0.03 * length)
    assert size[-1] <= 1.03 * length


def test_a_hammer_askew_measures_a_fifth_less():
    handle = trimesh.creation.box((0.3, 0.03, 0.03))
    head = trimesh.creation.box((0.03, 0.12, 0.03)).apply_translation((0.15, 0, 0))
    points = np.concatenate([handle.vertices, head.vertices])
    turn = Rotation.from_euler("z", 37, degrees=True).as_matrix()
    askew = points @ turn.T
    size = np.ptp(askew @ squaring_turn(askew).T, axis=0)
    assert sorted(size) == pytest.approx([0.03, 0.12, 0.315], abs=1e-9)


def test_what_is_round_or_square_to_the_axes_stays():
    round_one = np.asarray(trimesh.creation.cylinder(0.04, 0.1, sections=64).vertices)
    assert (squaring_turn(round_one) == np.eye(3)).all()
    assert (squaring_turn(np.asarray(trimesh.creation.box((1, 2, 3)).vertices)) == np.eye(3)).all()
