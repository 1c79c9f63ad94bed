from __future__ import annotations

import numpy as np
import pytest
import trimesh

from probe.assets.mesh.normals import smooth_normals, weld


def test_a_box_keeps_its_edges():
    box = trimesh.creation.box((1, 2, 3))
    old, normals, faces = smooth_normals(np.asarray(box.vertices), np.asarray(box.faces))
    assert len(old) == 24
    assert np.abs(normals[faces] - np.asarray(box.face_normals)[:, None]).max() < 1e-6
    assert (np.asarray(box.vertices)[old][faces] == np.asarray(box.triangles)).all()


def test_a_sphere_is_smooth():
    ball = trimesh.creation.icosphere(subdivisions=3)
    old, normals, _ = smooth_normals(np.asarray(ball.vertices), np.asarray(ball.faces))
    assert len(old) == len(ball.vertices)
    assert np.sum(normals * np.asarray(ball.vertices)[old], axis=1).min() > 0.999


def test_a_texture_seam_is_not_a_crease():
    ball = trimesh.creation.icosphere(subdivisions=3)
    torn = np.asarray(ball.triangles).reshape(-1, 3)
    old, normals, _ = smooth_normals(torn, np.arange(len(torn)).reshape(-1, 3))
    assert len(old) == len(torn)
    assert np.sum(normals * torn[old], axis=1).min() > 0.999


@pytest.mark.parametrize(("crease", "count"), [(30.0, 8), (60.0, 6)])
def test_a_fold_is_sharp_beyond_the_angle(crease, count):
    # Two unit squares that meet along y at 45 degrees.
    slope = np.sqrt(0.5)
    vertices = np.array(
        [[-1, 0, 0], [-1, 1, 0], [0, 0, 0], [0, 1, 0], [slope, 0, slope], [slope, 1, slope]]
    )
    faces = np.array([[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]])
    assert len(smooth_normals(vertices, faces, crease)[0]) == count


def test_three_faces_on_one_edge_and_slivers_do_no_harm():
    vertices = np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0], [0.5, 0, 0]], float
    )
    faces = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 5, 1]])
    _, normals, _ = smooth_normals(vertices, faces)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0)


def test_weld_numbers_places():
    numbers = weld(np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1e-8]]))
    assert numbers[0] == numbers[2] != numbers[1]
