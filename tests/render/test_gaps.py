from __future__ import annotations

import numpy as np
import pytest

from probe.render.gaps import without_gaps


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_pixel_without_a_depth_has_that_of_one_beside_it(bad: float):
    depth = np.full((5, 6), 1.2, np.float32)
    depth[:, 3:] = 0.9
    depth[2, 4] = bad
    mended = without_gaps(depth)
    assert mended.dtype == np.float32 and mended[2, 4] == np.float32(0.9)
    depth[2, 4] = mended[2, 4]
    assert (mended == depth).all()


def test_a_whole_picture_stays_the_same_array():
    depth = np.full((5, 6), 1.2, np.float32)
    assert without_gaps(depth) is depth
