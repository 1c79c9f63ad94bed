"""Volumes of solids whose volume is known, and hulls around them."""

import math

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from probe.assets.procedural.form.cuboid import rounded_box
from probe.assets.procedural.form.hulls import hull, shell
from probe.assets.procedural.form.lathe import Base, turn
from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.form.sweep import section, sweep

CYLINDER = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]])


def closed(sheets: list[Sheet]) -> trimesh.Trimesh:
    points = [sheet.points.reshape(-1, 3) for sheet in sheets]
    starts = np.cumsum([0, *(len(p) for p in points)])
    faces = [sheet.faces + k for sheet, k in zip(sheets, starts[:-1], strict=True)]
    return trimesh.Trimesh(np.vstack(points), np.vstack(faces))  # merges equal points


def test_a_turned_cylinder() -> None:
    solid = closed(turn([CYLINDER], Base(segments=96), [False]))
    assert solid.is_watertight
    assert solid.volume == pytest.approx(2 * math.pi, rel=2e-3)


def test_a_profile_led_around_a_rectangle() -> None:
    solid = closed(turn([CYLINDER], Base((3.0, 2.0), corner=1.0, segments=96), [False]))
    area = 6 * 4 + 2 * (6 + 4) * 1 + math.pi
    assert solid.is_watertight
    assert solid.volume == pytest.approx(2 * area, rel=2e-3)


def test_edges_are_sharp_and_walls_smooth() -> None:
    (sheet,) = turn([CYLINDER], Base(), [False])
    across = np.abs(sheet.normals[..., 2])
    assert np.all((across < 1e-6) | (across > 1 - 1e-6))
    wall = sheet.normals[across < 0.5]
    spots = sheet.points[across < 0.5]
    np.testing.assert_allclose(wall[:, :2], spots[:, :2], atol=1e-6)


@given(st.floats(0.01, 0.49))
def test_a_rounded_box(radius: float) -> None:
    size = np.array([3.0, 2.0, 1.0])
    solid = closed(list(rounded_box(size, radius).values()))
    np.testing.assert_allclose(solid.extents, size, atol=1e-9)
    assert solid.is_watertight
    a, b, c = size - 2 * radius
    inner = a * b * c + 2 * radius * (a * b + b * c + c * a)
    exact = inner + math.pi * radius**2 * (a + b + c) + 4 / 3 * math.pi * radius**3
    assert solid.volume == pytest.approx(exact, rel=0.02)


def test_the_picture_of_a_box_is_not_mirrored() -> None:
    for sheet in rounded_box(np.array([3.0, 2.0, 1.0]), 0.1).values():
        down, right = np.gradient(sheet.points, axis=0), np.gradient(sheet.points, axis=1)
        u, v = np.gradient(sheet.uvs[..., 0], axis=1), np.gradient(sheet.uvs[..., 1], axis=0)
        seen = np.cross(right * np.sign(u)[..., None], down * np.sign(v)[..., None])
        middle = tuple(n // 2 for n in sheet.points.shape[:2])
        assert seen[middle] @ sheet.normals[middle] <= 0  # v runs down: right x down points in


def test_a_swept_bar() -> None:
    path = np.column_stack([np.linspace(0, 5, 11), np.zeros(11), np.zeros(11)])
    half = np.tile([1.0, 0.5], (11, 1))
    sheet = sweep(path, half, section(2.0, 97), np.array([0.0, 0.0, 1.0]), fillet=0.0)
    solid = closed([sheet])
    assert solid.is_watertight
    assert solid.volume == pytest.approx(5 * math.pi * 0.5, rel=5e-3)


def test_pixels_lie_on_the_surface() -> None:
    (sheet,) = turn([CYLINDER[1:3]], Base(segments=128), [False])
    places = sheet.map(64, 32)
    assert places.shape == (32, 64, 3)
    np.testing.assert_allclose(np.linalg.norm(places[..., :2], axis=-1), 1, atol=1e-3)
    assert np.all(np.diff(places[:, 0, 2]) < 0)  # the first row is the top


def test_a_hull_of_many_points_is_small_and_close() -> None:
    points = np.random.default_rng(0).standard_normal((3000, 3))
    points *= 0.04 / np.linalg.norm(points, axis=1, keepdims=True)
    corners = hull(points)
    planes = ConvexHull(corners).equations
    assert len(corners) <= 64
    assert (points @ planes[:, :3].T + planes[:, 3]).max() < 0.002
    assert np.linalg.norm(corners, axis=1).max() < 0.042


def test_a_shell_leaves_its_cavity_open() -> None:
    outer = np.array([[0.0, 0.0], [0.05, 0.0], [0.05, 0.1]])
    inner = np.array([[0.0, 0.005], [0.045, 0.005], [0.045, 0.1]])
    rim = np.array([[0.0475, 0.1025]])
    pieces = shell(outer, inner, rim, Base(), bands=1, sectors=16)
    volume = sum(ConvexHull(corners).volume for corners in pieces)
    exact = math.pi * (0.05**2 * 0.005 + (0.05**2 - 0.045**2) * 0.095)
    assert len(pieces) == 17
    assert volume == pytest.approx(exact, rel=0.15)


@given(st.floats(0.5, 2), st.floats(0.5, 2), st.floats(0.5, 2))
def test_a_stretched_sheet(x: float, y: float, z: float) -> None:
    (sheet,) = turn([CYLINDER], Base(segments=128), [False])
    factors = np.array([x, y, z])
    stretched = sheet.stretched(factors)
    before, after = closed([sheet]), closed([stretched])
    assert after.volume == pytest.approx(before.volume * x * y * z, rel=1e-6)
    np.testing.assert_allclose(np.linalg.norm(stretched.normals, axis=-1), 1)
    # Normals stay at right angles to the surface along rows and columns.
    along = np.diff(stretched.points, axis=0)
    middle = (stretched.normals[1:] + stretched.normals[:-1]) / 2
    flat = np.linalg.norm(stretched.normals[1:] - stretched.normals[:-1], axis=-1) < 1e-9
    assert np.abs((along * middle).sum(axis=-1)[flat]).max() < 1e-9


def test_a_sheet_stretched_evenly_is_scaled() -> None:
    for sheet in rounded_box(np.array([3.0, 2.0, 1.0]), 0.1).values():
        scaled, stretched = sheet.scaled(1.5), sheet.stretched(np.full(3, 1.5))
        np.testing.assert_allclose(stretched.points, scaled.points)
        np.testing.assert_allclose(stretched.normals, scaled.normals, atol=1e-12)
        np.testing.assert_allclose(stretched.extent, scaled.extent)
        np.testing.assert_allclose(np.asarray(stretched.plane), np.asarray(scaled.plane))
