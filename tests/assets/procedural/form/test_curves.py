import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.procedural.form.curves import arc_length, filleted, resampled

CORNER = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]])


@given(st.floats(0.01, 0.4))
def test_a_fillet_is_an_arc_of_its_radius(radius: float) -> None:
    corners = CORNER.copy()
    corners[1, 2] = radius
    arc = filleted(corners)[1:-1]
    centre = np.array([1 - radius, radius])
    np.testing.assert_allclose(np.linalg.norm(arc - centre, axis=1), radius, rtol=1e-6)


def test_without_a_radius_a_corner_stays() -> None:
    np.testing.assert_allclose(filleted(CORNER), CORNER[:, :2])


def test_a_radius_that_does_not_fit_is_cut_down() -> None:
    corners = CORNER.copy()
    corners[1, 2] = 50.0
    curve = filleted(corners)
    assert curve.min() >= 0
    assert curve.max() <= 1


def test_resampling_keeps_the_length() -> None:
    line = np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 5.0]])
    dense = resampled(line, 0.1)
    assert arc_length(dense)[-1] == pytest.approx(6.0)
    assert np.linalg.norm(np.diff(dense, axis=0), axis=1).max() <= 0.1 + 1e-9
