from __future__ import annotations

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from probe.assets.cache import Cache
from probe.assets.collision.cavity import find_cavity
from probe.assets.collision.hulls import corners, span
from probe.assets.collision.pieces import convex_pieces, solidity
from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.assets.pools.scans import scan_body


def _textured(mesh: trimesh.Trimesh) -> TexturedMesh:
    mesh = mesh.copy()
    mesh.apply_translation([0, 0, -mesh.bounds[0][2]])
    return TexturedMesh(
        np.asarray(mesh.vertices, np.float32),
        np.asarray(mesh.vertex_normals, np.float32),
        np.zeros((len(mesh.vertices), 2), np.float32),
        np.asarray(mesh.faces, np.int32),
        Material(np.zeros((1, 1, 3), np.uint8)),
    )


def _cup(
    radius: float = 0.04, height: float = 0.09, wall: float = 0.004, sections: int = 64
) -> trimesh.Trimesh:
    """A tumbler as a body of revolution, watertight."""
    profile = [
        [0, 0],
        [radius, 0],
        [radius, height],
        [radius - wall, height],
        [radius - wall, wall],
        [0, wall],
    ]
    return trimesh.creation.revolve(profile, sections=sections)


def _inside(pieces, points) -> np.ndarray:
    """Whether each point lies in some piece, by more than a micrometre."""
    found = np.zeros(len(points), bool)
    for piece in pieces:
        equations = ConvexHull(piece.vertices).equations
        found |= (points @ equations[:, :3].T + equations[:, 3] < -1e-6).all(axis=1)
    return found


def _volume(pieces) -> float:
    return sum(ConvexHull(piece.vertices).volume for piece in pieces)


def test_a_box_is_its_hull():
    (piece,) = convex_pieces(_textured(trimesh.creation.box((0.1, 0.2, 0.05))), hollow=False)
    assert len(piece.vertices) == 8
    assert ConvexHull(piece.vertices).volume == pytest.approx(0.001)


def test_a_ball_keeps_its_shape_with_few_corners():
    ball = trimesh.creation.icosphere(subdivisions=4, radius=0.05)
    (piece,) = convex_pieces(_textured(ball), hollow=False)
    assert len(piece.vertices) <= 63
    assert ConvexHull(piece.vertices).volume > 0.85 * ball.volume


def test_a_cup_stays_open_and_its_wall_closed():
    cup = _cup()
    pieces = convex_pieces(_textured(cup), hollow=True)
    angle = np.linspace(0, 2 * np.pi, 50, endpoint=False)
    rim = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    for height in (0.008, 0.03, 0.06, 0.085):
        within = np.column_stack([0.034 * rim, np.full(50, height)])
        assert not _inside(pieces, within).any()
        wall = np.column_stack([0.0385 * rim, np.full(50, height)])
        assert _inside(pieces, wall).mean() > 0.95
    assert _inside(pieces, np.column_stack([0.02 * rim, np.full(50, 0.002)])).all()
    assert not _inside(pieces, np.array([[0, 0, -1e-3], [0.0415, 0, 0.05]])).any()


@pytest.mark.parametrize("turn", [180, 90, 33])
def test_a_cup_may_stand_on_its_head_or_lie(turn):
    cup = _cup().apply_transform(
        trimesh.transformations.rotation_matrix(np.radians(turn), [1, 0, 0])
    )
    pieces = convex_pieces(_textured(cup), hollow=True)
    assert _volume(pieces) < 0.25 * cup.convex_hull.volume + cup.volume


def test_a_hole_through_a_ring_stays_open():
    ring = trimesh.creation.torus(0.05, 0.012, major_sections=24, minor_sections=10)
    pieces = convex_pieces(_textured(ring), hollow=False)
    assert not _inside(pieces, np.array([[0, 0, 0.012], [0.025, 0, 0.012]])).any()
    assert _volume(pieces) < 1.35 * ring.volume


def test_a_body_without_cavity_may_claim_to_be_hollow():
    box = trimesh.creation.box((0.1, 0.2, 0.05))
    assert _volume(convex_pieces(_textured(box), hollow=True)) == pytest.approx(0.001, rel=1e-3)


@pytest.mark.parametrize("hollow", [True, False])
def test_a_torn_mesh_works_and_repeats(hollow):
    cup = _cup(sections=32)
    keep = np.ones(len(cup.faces), bool)
    keep[::17] = False
    cup.update_faces(keep)
    assert not cup.is_watertight
    first, second = (convex_pieces(_textured(cup), hollow) for _ in range(2))
    assert len(first) == len(second)
    assert all((a.vertices == b.vertices).all() for a, b in zip(first, second, strict=True))
    assert all(4 <= len(piece.vertices) <= 63 for piece in first)


def test_pieces_stay_within_the_hull():
    blob = trimesh.creation.icosphere(subdivisions=4, radius=0.04)
    vertices = np.asarray(blob.vertices)
    blob.vertices = vertices * (
        1 + 0.5 * np.sin(60 * vertices[:, :1]) * np.cos(50 * vertices[:, 1:2])
    )
    mesh = _textured(blob)
    equations = ConvexHull(mesh.vertices.astype(float)).equations
    for piece in convex_pieces(mesh, hollow=False):
        assert (piece.vertices @ equations[:, :3].T + equations[:, 3]).max() < 1e-9


def test_solidity_of_half_a_box():
    box = trimesh.creation.box((1, 1, 1))
    wedge = trimesh.convex.convex_hull(
        np.asarray(box.vertices)[np.asarray(box.vertices)[:, 0] < 0.6]
    )
    assert solidity(np.asarray(wedge.vertices), np.asarray(wedge.faces)) == pytest.approx(1)
    cup = _cup(0.04, 0.09, 0.004)
    solid = np.pi * (0.04**2 * 0.09 - 0.036**2 * 0.086)
    whole = np.pi * 0.04**2 * 0.09
    found = solidity(np.asarray(cup.vertices), np.asarray(cup.faces))
    assert found == pytest.approx(solid / whole, rel=0.01)


def test_flat_points_have_no_corners():
    flat = np.random.default_rng(0).random((50, 3)) * [1, 1, 0]
    assert corners(flat) is None
    assert corners(flat[:3]) is None
    assert corners(flat + np.random.default_rng(1).random((50, 3)) * [0, 0, 1e-5]) is None


def test_span_of_a_box():
    box = np.asarray(trimesh.creation.box((2, 2, 1)).vertices)
    bottom, top = span(box, np.array([[0, 0], [0.9, -0.9], [1.1, 0]]))
    assert bottom[:2] == pytest.approx(-0.5) and top[:2] == pytest.approx(0.5)
    assert top[2] < bottom[2]


def test_a_cup_holds_what_it_holds():
    cup = _cup(0.04, 0.09, 0.004)
    cavity = find_cavity(np.asarray(cup.vertices), np.asarray(cup.faces))
    assert cavity is not None
    assert cavity.mouth_from_object[2].tolist() == [0, 0, 1]
    assert cavity.middle == pytest.approx([0, 0, 0.09], abs=2e-3)
    assert cavity.volume == pytest.approx(np.pi * 0.036**2 * 0.086, rel=0.1)
    assert cavity.kept([np.asarray(cup.vertices)]) == pytest.approx(0, abs=1e-6)
    assert cavity.kept([]) == 1


def test_a_box_has_no_cavity():
    box = trimesh.creation.box((0.1, 0.2, 0.05))
    assert find_cavity(np.asarray(box.vertices), np.asarray(box.faces)) is None


@pytest.mark.slow
@pytest.mark.parametrize(
    "id", ["ycb_025_mug", "ycb_029_plate", "gso_mug_white_yellow", "ph_teacup"]
)
def test_real_cavities_stay_open(assets, cache, id):
    body = scan_body(id, assets / "scans", Cache(cache / "bodies"))
    vertices, faces = body.mesh.vertices.astype(float), body.mesh.faces
    cavity = find_cavity(vertices, faces)
    assert cavity is not None
    assert cavity.kept([piece.vertices for piece in body.pieces]) > 0.9
