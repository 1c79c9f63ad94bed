"""What holds for any built-in object, and for any two."""

from __future__ import annotations

import traceback
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
import trimesh

from probe.assets.mesh.mesh import Body
from probe.assets.mesh.nearness import SAME_FIT, Fingerprint, NearPair, compare, fingerprint
from probe.assets.pools.procedural import body_to_compare
from probe.assets.procedural import specs
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.tables import NEWEST_EDITION, entries
from probe.assets.spec import ObjectSpec
from probe.types import Array

SAME_COLOURS = 0.15  # share of the surface whose colour the other doesn't have
# Slender things whose surfaces nearly coincide, but whose tines, wheel, blade or jaws one sees at
# once.
TOLD_APART = (
    {"spoon", "own fork"},
    {"spoon", "own wrench"},
    {"wooden_spoon", "own wrench"},
    {"own fork", "own wrench"},
    {"own putty knife", "own table knife"},
    {"own putty knife", "own pizza cutter"},
)

MINOR = {"proc_pear"}  # its yellow is a tinge of the green


@dataclass(frozen=True, eq=False)
class MadeObject:
    """An object's fingerprint, and what is wrong with it."""

    seen: Fingerprint
    wrong: str


def every_object(nth: int = 1) -> dict[str, MadeObject]:
    """All built-in objects by id, which takes minutes, or every nth."""
    return {spec.id: _made(spec) for spec in specs(NEWEST_EDITION)[::nth]}


def looking_the_same(
    prints: Mapping[str, Fingerprint], alike: Iterable[NearPair]
) -> list[tuple[str, str]]:
    """Of near-duplicates whatever their size, those of one size, mostly in the same colours."""
    return [
        (pair.one, pair.other)
        for pair in alike
        if (near := compare(prints[pair.one], prints[pair.other])) is not None
        and near[0] <= SAME_FIT
        and near[1] <= SAME_COLOURS
        and {entries(2)[pair.one].shape, entries(2)[pair.other].shape} not in TOLD_APART
    ]


def _made(spec: ObjectSpec) -> MadeObject:
    body = body_to_compare(spec.id)
    wrong = ""
    try:
        check(spec, body)
    except AssertionError as error:
        wrong = f"{traceback.extract_tb(error.__traceback__)[-1].line} {error}"
    return MadeObject(fingerprint(body.mesh), wrong)


def check(spec: ObjectSpec, body: Body) -> None:
    """All that holds for any object."""
    check_mesh(spec, body)
    check_outside(body)
    check_pieces(spec, body)
    check_colours(spec, body)


def surface_colours(body: Body, count: int = 4000) -> Array:
    """Texture colours at points spread evenly over the surface, 0-1, shape (n, 3)."""
    mesh = body.mesh
    solid = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    points, faces = trimesh.sample.sample_surface(solid, count, seed=0)[:2]
    weights = trimesh.triangles.points_to_barycentric(solid.triangles[faces], points)
    uvs = (weights[..., None] * mesh.uvs[mesh.faces[faces]]).sum(axis=1)
    height, width = mesh.surface.texture.shape[:2]
    rows = np.clip((uvs[:, 1] * height).astype(int), 0, height - 1)
    columns = np.clip((uvs[:, 0] * width).astype(int), 0, width - 1)
    return mesh.surface.texture[rows, columns] / 255


def lab(srgb: Array) -> Array:
    """CIELAB (D65) of sRGB in 0-1, shape (..., 3); IEC 61966-2-1 and CIE 15."""
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    to_xyz = np.array(
        [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    )
    xyz = linear @ to_xyz.T / [0.9505, 1.0, 1.089]
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    x, y, z = np.moveaxis(f, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def check_mesh(spec: ObjectSpec, body: Body) -> None:
    mesh = body.mesh
    np.testing.assert_allclose(mesh.extent, spec.size, atol=1e-3)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    np.testing.assert_allclose((low + high)[:2] / 2, 0, atol=1e-4)
    assert abs(low[2]) < 1e-5
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-4)
    assert mesh.uvs.min() >= 0
    assert mesh.uvs.max() <= 1
    assert 200 <= len(mesh.faces) <= 20_000
    kinds = (mesh.vertices.dtype, mesh.normals.dtype, mesh.uvs.dtype, mesh.faces.dtype)
    assert kinds == (np.float32, np.float32, np.float32, np.int32)
    assert mesh.surface.texture.dtype == np.uint8


def check_pieces(spec: ObjectSpec, body: Body) -> None:
    assert 1 <= len(body.pieces) <= 40
    corners = np.vstack([piece.vertices for piece in body.pieces])
    low, high = corners.min(axis=0), corners.max(axis=0)
    middle = np.array([0, 0, spec.size[2] / 2])
    # What is for the eye alone (a stalk, bristles) may stick out of the pieces; nothing else.
    assert np.all(high <= middle + np.array(spec.size) / 2 + 0.003)
    assert np.all(low >= middle - np.array(spec.size) / 2 - 0.003)


def check_outside(body: Body) -> None:
    mesh = body.mesh
    solid = trimesh.Trimesh(mesh.vertices, mesh.faces)
    solid.merge_vertices(merge_tex=True, merge_norm=True)
    assert solid.volume > 0
    corners = mesh.vertices[mesh.faces].astype(float)
    directed = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    along = (directed * mesh.normals[mesh.faces].mean(axis=1)).sum(axis=1)
    areas = np.linalg.norm(directed, axis=1)
    assert areas[along <= 0].sum() < 1e-3 * areas.sum()


def check_colours(spec: ObjectSpec, body: Body) -> None:
    seen = lab(surface_colours(body))
    named = lab(np.array([rgb(colour) for colour in spec.colours], dtype=float))
    away = np.linalg.norm(seen[:, None] - named, axis=2)
    if len(named) == 1:
        assert np.linalg.norm(seen.mean(axis=0) - named[0]) < 25
    else:
        assert np.mean(away[:, 0] < 30) > 0.15
    if spec.id not in MINOR:
        assert np.mean(away < 30, axis=0).min() > 0.008
