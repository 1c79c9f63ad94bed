from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from probe.assets.gltf.glb import load_glb
from probe.assets.mesh.alignment import misfit
from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.assets.mesh.nearness import (
    compare,
    fingerprint,
    near_pairs,
    shape_distance,
    texture_distance,
)

ANGLE = st.floats(-180, 180)


def _mesh(solid: trimesh.Trimesh, colour=(200, 30, 30)) -> TexturedMesh:
    texture = np.full((4, 4, 3), colour, dtype=np.uint8)
    vertices = np.asarray(solid.vertices, np.float32)
    faces = np.asarray(solid.faces, np.int32)
    uvs = np.full((len(vertices), 2), 0.5, np.float32)
    return TexturedMesh(vertices, np.zeros_like(vertices), uvs, faces, Material(texture))


def _lamp(scale=1.0) -> trimesh.Trimesh:
    """Something without any symmetry."""
    foot = trimesh.creation.box((0.08, 0.06, 0.02))
    post = trimesh.creation.cylinder(0.008, 0.1).apply_translation((0.02, 0.01, 0.05))
    shade = trimesh.creation.cone(0.03, 0.05).apply_translation((0.01, -0.02, 0.1))
    return (foot + post + shade).apply_scale(scale)


@given(angles=st.tuples(ANGLE, ANGLE, ANGLE), shift=st.floats(-1, 1))
@settings(max_examples=10, deadline=None)
def test_a_copy_in_another_pose_is_near(angles, shift):
    turn = np.eye(4)
    turn[:3, :3] = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    turn[:3, 3] = shift
    one, other = fingerprint(_mesh(_lamp())), fingerprint(_mesh(_lamp().apply_transform(turn)))
    assert shape_distance(one, other) == pytest.approx(0, abs=1e-4)
    assert misfit(one.points, other.points) < 1e-3
    assert compare(one, other) is not None


def test_a_decimated_copy_in_other_colours_is_near():
    whole = _lamp().subdivide().subdivide()
    one = fingerprint(_mesh(_lamp()))
    other = fingerprint(_mesh(whole, (20, 40, 210)))
    assert texture_distance(one, other) > 0.9
    assert compare(one, other) is not None


@pytest.mark.parametrize("scale", [0.8, 1.25])
def test_another_size_is_another_object(scale):
    one, other = fingerprint(_mesh(_lamp())), fingerprint(_mesh(_lamp(scale)))
    assert shape_distance(one, other) == pytest.approx(abs(scale - 1) / ((1 + scale) / 2), rel=0.01)
    assert compare(one, other) is None


def test_another_shape_of_the_same_size_and_colour_is_another_object():
    ball = trimesh.creation.icosphere(3, 0.04)
    cube = trimesh.creation.box((0.065, 0.065, 0.065))
    assert compare(fingerprint(_mesh(ball)), fingerprint(_mesh(cube))) is None


def test_textures_far_apart_and_alike():
    lamp = _mesh(_lamp())
    print_of = [
        fingerprint(replace(lamp, surface=Material(np.full((4, 4, 3), colour, np.uint8))))
        for colour in ((200, 30, 30), (204, 34, 28), (20, 40, 210))
    ]
    assert texture_distance(print_of[0], print_of[0]) == 0
    assert texture_distance(print_of[0], print_of[1]) < 0.5
    assert texture_distance(print_of[0], print_of[2]) > 0.9


def test_pairs_are_found_among_many():
    turn = trimesh.transformations.rotation_matrix(1, (1, 2, 3))
    solids = {
        "lamp": _lamp(),
        "lamp again": _lamp().apply_transform(turn),
        "box": trimesh.creation.box((0.1, 0.05, 0.03)),
        "can": trimesh.creation.cylinder(0.03, 0.1),
    }
    (pair,) = near_pairs({name: fingerprint(_mesh(solid)) for name, solid in solids.items()})
    assert (pair.one, pair.other) == ("lamp", "lamp again")
    assert near_pairs({}) == []


@pytest.mark.slow
def test_known_pairs_among_scans_are_found_and_others_are_not(assets):
    near = [("pum_blue_cup", "pum_green_cup"), ("gso_android_orange", "gso_android_panda")]
    near += [("ycb_072_d_toy_airplane", "ycb_072_e_toy_airplane"), ("ph_sugar_bowl", "ph_teacup")]
    far = [("ycb_018_plum", "ycb_057_racquetball"), ("gsof_boot_black", "gsof_boot_brown")]
    far += [("ycb_025_mug", "ycb_065_i_cups"), ("gso_can_opener_black", "pum_remote_2")]
    ids = {name for pair in near + far for name in pair}
    prints = {name: fingerprint(load_glb(assets / "scans" / f"{name}.glb")) for name in ids}
    assert all(compare(prints[one], prints[other]) for one, other in near)
    assert not any(compare(prints[one], prints[other]) for one, other in far)
