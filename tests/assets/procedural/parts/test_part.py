import math

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from probe.assets.procedural.parts.ball import Ball
from probe.assets.procedural.parts.box import RoundedBox

RNG = np.random.default_rng(0)


def test_a_ball_has_its_diameters_and_volume() -> None:
    ball = Ball(kind="ball", size=(0.06, 0.04, 0.02), segments=64, paint="all")
    ((sheet, name),) = ball.placed_surfaces(RNG)
    solid = trimesh.Trimesh(sheet.points.reshape(-1, 3), sheet.faces)
    np.testing.assert_allclose(solid.extents, [0.06, 0.04, 0.02], rtol=1e-6)
    assert solid.volume == pytest.approx(math.pi / 6 * 0.06 * 0.04 * 0.02, rel=0.01)
    (corners,) = ball.placed_hulls(RNG)
    assert ConvexHull(corners).volume == pytest.approx(solid.volume, rel=0.05)
    assert name == "all"


def test_copies_are_shifted_and_turned() -> None:
    cube = {"kind": "box", "size": (0.01, 0.01, 0.01), "paint": "all"}
    row = RoundedBox.model_validate(cube | {"copies": {"count": 3, "step": (0.02, 0, 0)}})
    middles = [corners.mean(axis=0) for corners in row.placed_hulls(RNG)]
    np.testing.assert_allclose(middles, [[k * 0.02, 0, 0.005] for k in range(3)], atol=1e-9)
    assert len(row.placed_surfaces(RNG)) == 3 * 6
    place = {"at": (0.03, 0, 0)}
    ring = RoundedBox.model_validate(cube | {"place": place, "copies": {"count": 4, "turn": 90}})
    middles = [corners.mean(axis=0)[:2] for corners in ring.placed_hulls(RNG)]
    expected = [[0.03, 0], [0, 0.03], [-0.03, 0], [0, -0.03]]
    np.testing.assert_allclose(middles, expected, atol=1e-9)


def test_what_is_for_the_eye_alone_has_no_pieces() -> None:
    box = RoundedBox(kind="box", size=(0.01, 0.01, 0.01), paint="all", solid=False)
    assert box.placed_hulls(RNG) == []
    assert len(box.placed_surfaces(RNG)) == 6
