"""The fixed cameras see what their set-up says."""

import numpy as np
import pytest

from probe.scene.cameras import CameraPlacement
from probe.scene.setup import UR5_TABLE, picture_scale
from probe.types import USUAL_SCALE


@pytest.mark.parametrize(("height", "width"), [(1.2, 0.58), (0.7, 0.3), (2.0, 1.1)])
def test_a_camera_above_sees_a_square_of_the_stated_width(height, width):
    placed = CameraPlacement.above(height, width)
    assert placed.width == width
    corners = width / 2 * np.array([[-1.0, 1.0, 0.0], [1.0, -1.0, 0.0]])
    assert placed.camera(600).project(corners) == pytest.approx(
        np.array([[0, 0], [600, 600]]), abs=1e-6
    )


def test_right_and_far_are_the_same_for_both_cameras():
    """What a push calls right is +x, and up is +y, in either picture."""
    steps = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]])
    for view in ("top", "front"):
        at, right, far = UR5_TABLE.camera(view).project(steps)
        assert right[0] > at[0] + 50 and abs(right[1] - at[1]) < 5
        assert far[1] < at[1] - 50 and abs(far[0] - at[0]) < 5


def test_the_usual_scale_is_that_of_the_usual_set_up():
    assert picture_scale(UR5_TABLE, UR5_TABLE.camera()) == USUAL_SCALE
