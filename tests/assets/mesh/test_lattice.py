from __future__ import annotations

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from probe.assets.mesh.lattice import lattice_points


@given(edges=st.tuples(*[st.floats(0.02, 0.3)] * 3), spacing=st.floats(0.005, 0.5))
def test_no_place_is_far_from_a_point(edges, spacing):
    box = trimesh.creation.box(edges)
    points = lattice_points(np.asarray(box.vertices), np.asarray(box.faces), spacing)
    places = trimesh.sample.sample_surface(box, 300, seed=1)[0]
    assert np.max(cKDTree(points).query(places)[0]) <= spacing
    assert np.abs(np.abs(points) / (np.array(edges) / 2)).max(axis=1) == pytest.approx(1)


def test_a_long_needle_stays_cheap():
    needle = np.array([[0, 0, 0], [1, 0, 0], [0, 0.001, 0]])
    for turn in ([0, 1, 2], [1, 2, 0], [2, 0, 1]):
        assert len(lattice_points(needle, np.array([turn]), 0.01)) == 2 * 102
