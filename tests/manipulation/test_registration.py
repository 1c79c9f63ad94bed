"""Rigid motions found again in depth pictures of an independent ray cast."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from probe.manipulation.looking import tracked
from probe.manipulation.registration import Motions, OrientedPoints, fit, register
from probe.manipulation.terrain import lifted
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Frame, Pose
from raycast import cast
from shapes import box

CAMERA = UR5_TABLE.top.camera(512)
MESHES = {"book": box(0.12, 0.08, 0.03, 90, 90, 90), "post": box(0.04, 0.04, 0.1, 90, 90, 90)}
POST = PlacedObject(2, "post", Pose((-0.15, 0.1, 0.0)))


def book(x=0.0, y=0.0, turn=0.0, tip=0.0, z=0.0) -> PlacedObject:
    """A book, turned about the vertical, then tipped about x; it lies or leans at height z."""
    rotation = Rotation.from_rotvec([tip, 0, 0]) * Rotation.from_rotvec([0, 0, turn])
    wxyz = np.roll(rotation.as_quat(), 1)
    return PlacedObject(1, "book", Pose.of(np.array([x, y, z]), wxyz))


def look(*objects: PlacedObject) -> tuple[Frame, np.ndarray]:
    labels, depth = cast(objects, MESHES, CAMERA, UR5_TABLE.table_size)
    return Frame(CAMERA, depth.astype(np.float32)), labels == 1


@pytest.mark.parametrize("degrees", [0, 15, 35])
@pytest.mark.parametrize("turn", [0, 20])
def test_a_thing_that_tipped_is_found_where_it_leans(degrees: int, turn: int) -> None:
    start, end = book(), book(0.01, 0.07, np.radians(turn), np.radians(degrees), z=0.03)
    before, mask = look(start, POST)
    after, expected = look(end, POST)
    found = tracked(before, after, mask, np.array([0.0, 0.1, 0.0]))
    assert found is not None
    points = lifted(before, mask)
    moved = (end.pose @ start.pose.inverse()).apply(points).mean(axis=0) - points.mean(axis=0)
    assert found.shift == pytest.approx(moved, abs=0.004)
    assert (found.mask & expected).sum() > 0.8 * found.mask.sum()


def test_points_that_lie_on_the_surface_stay_there() -> None:
    frame, mask = look(book(), POST)
    surface = OrientedPoints.of(frame, mask)
    points = lifted(frame, mask)[::40]
    still = Motions(np.eye(3)[None], np.zeros((1, 3)), points.mean(axis=0))
    assert fit(surface, points, still, 0.001)[0][0] == 1.0
    settled = register(surface, points, still)
    assert settled.apply(points)[0] == pytest.approx(points, abs=1e-4)


def test_what_would_hide_what_is_seen_counts_against_a_place() -> None:
    frame, mask = look(book(), POST)
    surface = OrientedPoints.of(frame, mask)
    points = lifted(frame, mask)[::40]
    raised = Motions(np.eye(3)[None], np.array([[0.0, 0.0, 0.02]]), points.mean(axis=0))
    shown, hiding = fit(surface, points, raised, 0.004)
    assert shown[0] == 0.0 and hiding[0] == 1.0
