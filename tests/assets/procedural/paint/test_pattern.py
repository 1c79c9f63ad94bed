import numpy as np
import pytest

from probe.assets.procedural.form.lathe import Base, turn
from probe.assets.procedural.paint.canvas import Canvas
from probe.assets.procedural.paint.pattern import Pattern

PIPE = np.array([[0.03, 0.0], [0.03, 0.12]])


def drawn(figure: str, **values: float) -> np.ndarray:
    """Share of the figure at each pixel of a pipe's wall."""
    (sheet,) = turn([PIPE], Base(segments=64), [False])
    canvas = Canvas(sheet, 600, 382, 600 / sheet.extent[0])
    look = Pattern.model_validate(
        {"figure": figure, "colour": "#000000", "second": "#ffffff", "grain": 0, **values}
    )
    return look.draw(canvas, np.random.default_rng(0)).mean(axis=-1)


@pytest.mark.parametrize(
    ("figure", "share", "covered"),
    [
        ("stripes", 0.3, 0.3),
        ("bands", 0.6, 0.6),
        ("checks", 0.5, 0.5),
        ("dots", 0.5, 2 * np.pi * 0.25**2),  # two dots a square repeat
        ("diamonds", 0.4, 2 * 0.4**2),
    ],
)
def test_a_figure_takes_its_share(figure: str, share: float, covered: float) -> None:
    assert drawn(figure, share=share).mean() == pytest.approx(covered, abs=0.04)


@pytest.mark.parametrize("figure", ["stripes", "checks", "dots", "diamonds"])
def test_a_pattern_closes_around_a_pipe(figure: str) -> None:
    picture = drawn(figure)
    across_seam = np.abs(picture[:, 0] - picture[:, -1]).mean()
    anywhere = np.abs(np.diff(picture, axis=1)).mean(axis=0).max()
    assert across_seam <= anywhere + 0.02


def test_the_pitch_is_the_width_of_a_repeat() -> None:
    row = drawn("stripes", pitch=0.02)[100] > 0.5
    edges = np.count_nonzero(row[1:] != row[:-1]) + (row[0] != row[-1])
    assert edges == 2 * round(2 * np.pi * 0.03 / 0.02)
