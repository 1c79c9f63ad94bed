from dataclasses import replace

import numpy as np
import pytest

from probe.perception.depths import SPREAD, depth_change, same_within, tolerance
from tabletops import Block, paint

FRAME = paint([Block(1, (300, 300, 400, 400))])


def test_exact_cameras_keep_their_thresholds():
    assert tolerance(0.003) == tolerance(0.003, 0.0, 0.0) == 0.003
    assert same_within(0.003, FRAME, FRAME) == 0.003


def test_noise_of_both_frames_adds_up_as_that_of_a_difference():
    one, other = replace(FRAME, depth_noise=0.0003), replace(FRAME, depth_noise=0.0004)
    assert same_within(0.003, one, other) == pytest.approx(0.003 + SPREAD * 0.0005)


def test_nothing_is_known_of_a_change_without_a_reading():
    measured = np.ones(FRAME.depth.shape, bool)
    measured[350, 350] = False
    later = replace(paint([]), measured=measured)
    change = depth_change(FRAME, later)
    assert change[350, 350] == 0 and change[351, 351] == pytest.approx(0.05, abs=1e-4)
    assert depth_change(later, FRAME)[350, 350] == 0
