"""Near-duplicates whatever their size, of meshes made here."""

from __future__ import annotations

import numpy as np
import trimesh

from probe.assets.mesh.likeness import like_pairs
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.nearness import fingerprint
from shapes import plain, textured

RED, CRIMSON, BLUE = (178, 34, 36), (190, 50, 45), (36, 78, 158)


def lamp(scale: float = 1.0, colour: tuple[int, int, int] = RED) -> TexturedMesh:
    """Something without any symmetry, turned according to its size."""
    foot = trimesh.creation.box((0.08, 0.06, 0.02))
    post = trimesh.creation.cylinder(0.008, 0.1).apply_translation((0.02, 0.01, 0.05))
    shade = trimesh.creation.cone(0.03, 0.05).apply_translation((0.01, -0.02, 0.1))
    turn = trimesh.transformations.rotation_matrix(scale, (1, 2, 3))
    whole = (foot + post + shade).apply_scale(scale).apply_transform(turn)
    return textured(whole, plain(*colour))


def pairs(**meshes: TexturedMesh) -> list[tuple[str, str]]:
    prints = {name: fingerprint(mesh) for name, mesh in meshes.items()}
    return sorted((pair.one, pair.other) for pair in like_pairs(prints))


def test_size_and_a_shade_make_no_difference():
    assert pairs(a=lamp(), b=lamp(1.7), c=lamp(0.6, CRIMSON)) == [
        ("a", "b"),
        ("a", "c"),
        ("b", "c"),
    ]


def test_another_colour_makes_another_object():
    assert pairs(a=lamp(), b=lamp(colour=BLUE)) == []


def test_another_shape_makes_another_object():
    ball = textured(trimesh.creation.icosphere(3, 0.04), plain(*RED))
    cube = textured(trimesh.creation.box((0.07, 0.07, 0.07)), plain(*RED))
    assert pairs(a=lamp(), b=ball, c=cube) == []


def test_other_proportions_make_another_object():
    low, tall = (trimesh.creation.box((0.1, 0.06, height)) for height in (0.03, 0.05))
    assert pairs(a=textured(low, plain(*RED)), b=textured(tall, plain(*RED))) == []


def test_a_pattern_on_half_of_it_makes_another_object():
    stripes = np.array([[RED, (240, 238, 232)]], dtype=np.uint8)
    shape = trimesh.creation.box((0.1, 0.06, 0.03))
    half = textured(shape, stripes)
    left = half.vertices[:, 0] < 0
    half.uvs[:, 0] = np.where(left, 0.25, 0.75)
    assert pairs(a=textured(shape, plain(*RED)), b=half) == []
    assert pairs(a=half, b=half) == [("a", "b")]
