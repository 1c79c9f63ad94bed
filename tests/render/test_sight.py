"""What may be left out of a picture: nothing of which a point would show."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.render.sight import may_show
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Camera, Pose, looking_at
from shapes import box, grey_table

BOUNDS = (np.array([-0.05, -0.02, 0.0]), np.array([0.03, 0.06, 0.2]))
CAMERAS = (
    UR5_TABLE.camera(),
    UR5_TABLE.basket_camera,
    Camera(looking_at(np.array([0.5, -0.6, 0.7]), np.array([0.0, 0.0, 0.05])), 640, 480, 40),
)

metres = st.floats(-0.8, 0.8)
turns = st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda turn: np.linalg.norm(turn) > 0.1)


@given(st.tuples(metres, metres, metres), turns, st.sampled_from(CAMERAS), st.integers(0, 2**32))
def test_a_box_of_which_a_point_shows_may_show(position, turn, camera, seed):
    pose = Pose.of(np.array(position), np.array(turn))
    within = np.random.default_rng(seed).uniform(*BOUNDS, size=(200, 3))
    u, v = camera.project(pose.apply(within)).T
    shows = (u >= 0) & (u <= camera.width_px) & (v >= 0) & (v <= camera.height_px)
    if shows.any():
        assert may_show(BOUNDS, pose, camera)


@pytest.mark.parametrize("camera", CAMERAS[:2], ids=["table", "basket"])
def test_what_lies_at_the_other_cameras_place_does_not(camera):
    """The basket stands beside what the camera above the table sees."""
    table, basket = Pose((0.0, 0.0, 0.0)), Pose(UR5_TABLE.basket.position)
    here, there = (table, basket) if camera is CAMERAS[0] else (basket, table)
    assert may_show(BOUNDS, here, camera)
    assert not may_show(BOUNDS, there, camera)


def test_what_reaches_into_the_picture_is_painted_and_the_rest_changes_nothing(renderer):
    renderer.load({"slab": box(0.20, 0.12, 0.04, 200, 40, 30)}, grey_table())
    camera = UR5_TABLE.top.camera(256)
    inside = PlacedObject(1, "slab", Pose((0.0, 0.0, 0.0)))
    edge = 0.58 / 2
    reaching = PlacedObject(2, "slab", Pose((edge + 0.08, 0.0, 0.0)))
    beyond = PlacedObject(3, "slab", Pose((edge + 0.3, 0.0, 0.0)))
    alone = renderer.paint([inside], camera)
    assert (renderer.paint([inside, beyond], camera) == alone).all()
    red = renderer.paint([inside, reaching], camera).astype(int) - alone
    assert (np.abs(red).max(axis=2) > 30)[:, -4:].sum() > 100
