from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from probe.perception.relief import relief
from probe.scene.setup import UR5_TABLE
from probe.types import Frame
from tabletops import Block, paint


def surface(heights):
    grey = np.full((*heights.shape, 3), 128, np.uint8)
    depth = (UR5_TABLE.top.eye[2] - heights).astype(np.float32)
    return Frame(UR5_TABLE.top.camera(len(heights)), depth, grey)


@settings(max_examples=15, deadline=None)
@given(st.floats(-1, 1), st.floats(-1, 1))
def test_a_slope_is_no_edge(across, down):
    rows, columns = np.indices((256, 256)) * 0.58 / 256
    found = relief(surface(0.2 + across * columns / 4 + down * rows / 4))
    inner = slice(8, -8), slice(8, -8)
    assert found.step[inner].max() < 0.01
    assert max(found.valley[inner].max(), found.ridge[inner].max()) < 0.01
    assert found.contrast.max() < 1e-6 and found.raised[inner].all()


@settings(max_examples=15, deadline=None)
@given(st.floats(0.005, 0.1))
def test_a_step_is_as_high_as_it_is(height):
    heights = np.zeros((256, 256))
    heights[:, 128:] = height
    found = relief(surface(heights))
    assert found.step[100, 126:130].max() == pytest.approx(1000 * height, rel=0.01)
    assert found.step[100, :120].max() < 0.01
    assert found.raised[:, 128:].all() and not found.raised[:, :128].any()


def test_valleys_and_ridges_are_told_apart():
    columns = np.tile(np.arange(256) - 128.0, (256, 1)) * 0.58 / 256
    bent = 2 * np.arctan(0.5)
    valley, ridge = relief(surface(0.1 + abs(columns) / 2)), relief(surface(0.2 - abs(columns) / 2))
    assert valley.valley[128, 128] == pytest.approx(bent, rel=0.2)
    assert ridge.ridge[128, 128] == pytest.approx(bent, rel=0.2)
    assert valley.ridge[20:-20, 128].max() < 0.05 and ridge.valley[20:-20, 128].max() < 0.05


def test_a_change_of_colour_alone_is_a_contrast():
    frame = paint([Block(1, (200, 200, 500, 500), height=0.0, colour=(200, 30, 30))])
    found = relief(frame)
    assert found.stride == 2
    assert found.contrast[150, 100] > 30 and found.contrast[150, 60] < 1
    assert found.step.max() == 0 and not found.raised.any()


def test_holes_in_the_depth_are_filled_from_beside():
    frame = paint([Block(1, (200, 200, 500, 500))])
    depth = frame.depth.copy()
    depth[300:320, 300:320], depth[10, 10], depth[11, 10] = np.nan, 0, np.inf
    assert np.array_equal(relief(frame).step, relief(replace(frame, depth=depth)).step)
