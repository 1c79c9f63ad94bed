import numpy as np
import pytest

from probe.errors import ProbeError
from probe.station.fusing import FRAMES, fused

TABLE = np.full((200, 120), 1.2, np.float32)
TABLE[60:120, 30:80] = 1.1


def readings(sigma, count=FRAMES, seed=3):
    rng = np.random.default_rng(seed)
    return [TABLE + sigma * rng.standard_normal(TABLE.shape) for _ in range(count)]


@pytest.mark.parametrize("sigma", [0.001, 0.002, 0.003])
def test_noise_goes_down_and_is_told_as_it_is_while_steps_stay(sigma):
    told = fused(readings(sigma))
    inner = np.s_[70:110, 40:70]
    left = (told.depth - TABLE)[inner].std()
    assert left < sigma / 4
    assert told.noise == pytest.approx(left, rel=0.25)
    assert told.measured is None
    assert np.abs(told.depth - TABLE)[62:118, 29:31].max() < 0.01


def test_holes_take_the_nearest_reading_and_are_told():
    depths = readings(0.001)
    for depth in depths:
        depth[50:60, 50:60] = 0
        depth[150:152, 10:12] = np.nan
    depths[0][20, 20] = 0
    told = fused(depths)
    assert told.measured is not None
    assert np.count_nonzero(~told.measured) == 104
    assert not told.measured[50:60, 50:60].any() and told.measured[20, 20]
    assert np.isfinite(told.depth).all() and told.depth.min() > 1.09


def test_what_flies_through_one_picture_leaves_no_trace():
    depths = readings(0.0)
    depths[4][100:140, 60:100] = 0.5
    told = fused(depths)
    # A median over 3 x 3 pixels keeps edges and rounds the box's four corners.
    assert np.count_nonzero(told.depth != TABLE) == 4
    assert told.noise == 0


def test_readings_that_one_picture_lacks_come_from_the_others():
    depths = readings(0.0)
    depths[0][70:110, 40:70] = 0
    told = fused(depths)
    assert told.measured is None and np.abs(told.depth - TABLE)[62:118, 32:78].max() == 0


def test_one_picture_keeps_its_readings():
    (only,) = readings(0.001, count=1)
    told = fused([only])
    assert np.array_equal(told.depth, only.astype(np.float32)) and told.noise == 0


def test_a_covered_camera_is_no_table():
    with pytest.raises(ProbeError, match="covered"):
        fused([np.zeros((4, 4)), np.full((4, 4), np.nan)])


def test_a_camera_of_whose_pictures_most_are_empty_is_no_table():
    """No pixel has a reading in half of them."""
    empty = [np.zeros((8, 8))] * 5
    with pytest.raises(ProbeError, match=r"Only 4 of the camera's 9 pictures have any depth"):
        fused([*[np.full((8, 8), 0.8)] * 4, *empty])
