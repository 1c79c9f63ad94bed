import numpy as np
import pytest

from probe.assets.procedural.form.cuboid import rounded_box
from probe.assets.procedural.form.lathe import Base, turn
from probe.assets.procedural.paint.canvas import Canvas


def ball_canvas() -> Canvas:
    angle = np.linspace(-np.pi / 2, np.pi / 2, 60)
    profile = 0.03 * np.column_stack([np.cos(angle), np.sin(angle)])
    (sheet,) = turn([profile], Base(), [False])
    return Canvas(sheet, 600, 300, 600 / sheet.extent[0])


def test_noise_has_no_seam() -> None:
    noise = ball_canvas().noise(np.random.default_rng(1), 0.01, octaves=2)
    across_seam = np.abs(noise[:, 0] - noise[:, -1]).max()
    assert across_seam < 0.2 * np.ptp(noise)
    assert abs(noise.mean()) < 1


def test_noise_is_the_same_for_the_same_seed() -> None:
    canvas = ball_canvas()
    first, second, other = (canvas.noise(np.random.default_rng(k), 0.01) for k in (5, 5, 6))
    np.testing.assert_array_equal(first, second)
    assert np.abs(first - other).max() > 0.1


@pytest.mark.parametrize("even", [False, True])
def test_spots_cover_their_share_of_the_surface(even: bool) -> None:
    side = rounded_box(np.array([0.1, 0.1, 0.1]), 0.001)["top"]
    canvas = Canvas(side, 500, 500, 5000)
    mask = canvas.spots(np.random.default_rng(2), 2.0, (0.001, 0.001), even)
    expected = 200 * np.pi * 0.001**2 / 0.01
    assert mask.mean() == pytest.approx(expected, rel=0.35)


def test_spots_on_a_ball_are_no_denser_at_its_poles() -> None:
    canvas = ball_canvas()
    mask = canvas.spots(np.random.default_rng(3), 30.0, (0.0003, 0.0003))
    cap, belt = mask[:50], mask[125:175]  # caps are small: rows count by their circumference
    weight = np.linalg.norm(canvas.places()[..., :2], axis=-1)
    share = [(m * w).sum() / w.sum() for m, w in ((cap, weight[:50]), (belt, weight[125:175]))]
    assert share[0] == pytest.approx(share[1], rel=0.3)
